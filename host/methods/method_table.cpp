#include "host/methods/method_table.hpp"

#include "host/core/frame_images.hpp"
#include "host/stages/background.hpp"
#include "host/stages/light_gain.hpp"
#include "host/stages/light_sums.hpp"
#include "host/stages/remodulate.hpp"
#include "host/stages/temporal_antialiasing.hpp"

namespace quell {

FilterLevel levelAfter(int iteration) {
  if (iteration == 0) return {"irradiance", "variance"};
  return iteration % 2 == 1 ? FilterLevel{"filteredOdd", "varianceOdd"}
                            : FilterLevel{"filteredEven", "varianceEven"};
}

std::vector<Wire> atrousWires(const FilterLevel& in, const FilterLevel& out) {
  return {{"irradiance", in.irradiance},
          {"variance", in.variance},
          {"filteredIrradiance", out.irradiance},
          {"filteredVariance", out.variance}};
}

void addWindows(Schedule& table, const BoxFilter::Setup& planes, std::array<int, 2> radius,
                const std::string& from, const std::string& to) {
  const std::string columns = to + "Columns";
  BoxFilter::Setup setup = planes;
  setup.radius = radius[1];
  add(table, BoxFilter(setup), {{"boxInput", from}, {"boxOutput", columns}});
  setup.radius = radius[0];
  setup.alongRows = true;
  add(table, BoxFilter(setup), {{"boxInput", columns}, {"boxOutput", to}});
}

void addLightGain(Schedule& table, const Configuration& configuration, const std::string& filtered) {
  add(table, LightSums(configuration), {{"filtered", filtered}});
  add(table, LightGain(configuration));
}

namespace {

bool antialiasesLinear(const AntialiasingSettings& antialiasing) {
  return antialiasing.antialiasLinear || antialiasing.jitteredRays;
}

}  // namespace

bool antialiases(const Configuration& configuration, const AntialiasingSettings& antialiasing) {
  const Output& output = configuration.output;
  const bool wanted =
      output.display.present() || (antialiasesLinear(antialiasing) && output.linear.present());
  return wanted && antialiasing.taa;
}

void addOutputStages(Schedule& table, const Configuration& configuration, const std::string& filtered,
                     const AntialiasingSettings& antialiasing, bool skip, BackgroundAntialiasing background,
                     bool keepLight) {
  const bool taa = antialiases(configuration, antialiasing);
  const bool always = background == BackgroundAntialiasing::Always || antialiasing.jitteredRays;
  const bool linear = taa && antialiasesLinear(antialiasing);
  requireFBetaImages(configuration);
  if (skip) add(table, Background(configuration, {taa, always, linear}));
  add(table, Remodulate(configuration, {taa, linear, keepLight, skip}), {{"filtered", filtered}});
  if (!taa) return;
  const double newestWeight =
      antialiasing.jitteredRays ? antialiasing.taaJitteredWeight : antialiasing.taaNewestWeight;
  add(table, TemporalAntialiasing(configuration, {newestWeight, antialiasing.taaSilhouetteWeight, linear,
                                                  always, skip && !always}));
}

}  // namespace quell
