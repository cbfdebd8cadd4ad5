// atrous: edge-avoiding a-trous wavelets, Dammertz et al. 2010.
#include "host/stages/atrous.hpp"

#include "host/methods/atrous_settings.hpp"
#include "host/methods/method.hpp"
#include "host/methods/method_table.hpp"
#include "host/stages/demodulate.hpp"

namespace quell {
namespace {

// Irradiance is not needed any more when the second iteration writes.
FilterLevel atrousLevelAfter(int iteration) {
  return {iteration % 2 == 1 ? "filteredOdd" : "irradiance", ""};
}

Schedule makeSchedule(const Configuration& configuration, const AtrousSettings& s) {
  Schedule table;
  add(table, Demodulate(configuration, s.skip));
  Atrous::Setup setup;
  setup.stops = s.stops;
  setup.skip = s.skip;
  for (int i = 1; i <= s.iterations; ++i) {
    setup.iteration = i;
    setup.luminanceSigma = s.luminanceSigma / (1 << (i - 1));
    add(table, Atrous(configuration, setup), atrousWires(atrousLevelAfter(i - 1), atrousLevelAfter(i)));
  }
  addOutputStages(table, configuration, atrousLevelAfter(s.iterations).irradiance, {}, s.skip);
  return table;
}

}  // namespace

Method atrousMethod() {
  return makeMethod("atrous", "edge-avoiding a-trous wavelets, one frame alone (Dammertz et al. 2010)",
                    atrousSettings(), makeSchedule);
}

}  // namespace quell
