// The structs that methods see of their settings: every setting arrives in a member of its own, and the runtime is told
// what it needs.
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <limits>

#include "host/methods/atrous_settings.hpp"
#include "host/methods/bmfr_settings.hpp"
#include "host/methods/edagi_settings.hpp"
#include "host/methods/guided_settings.hpp"
#include "host/methods/method.hpp"
#include "host/methods/quell_settings.hpp"
#include "host/methods/svgf_settings.hpp"
#include "tests/support/error_matcher.hpp"

namespace quell::tests {
namespace {

/// The member that a setting is expected in, as a number.
template <class S>
struct Reader {
  const char* name;
  std::function<double(const S&)> read;
};
template <class S>
using Readers = std::vector<Reader<S>>;

#define READ_AS(name, value)                                         \
  {                                                                  \
    name, [](const auto& s) { return static_cast<double>(s.value); } \
  }
#define READ(member) READ_AS(#member, member)

template <class S>
Readers<S> operator+(Readers<S> readers, const Readers<S>& more) {
  readers.insert(readers.end(), more.begin(), more.end());
  return readers;
}

template <class S>
Readers<S> filterReaders() {
  return {READ(iterations), READ(luminanceSigma), READ_AS("depthSigma", stops.depthSigma),
          READ_AS("normalPower", stops.normalPower), READ_AS("roughnessSigma", stops.roughnessSigma)};
}

template <class S>
Readers<S> commonReaders() {
  return {READ_AS("skip", common.skip),
          READ_AS("demodulate", common.demodulate),
          READ_AS("positionLimitFootprints", common.discard.positionLimitFootprints),
          READ_AS("positionLimit", common.discard.positionLimit),
          READ_AS("normalLimitSquared", common.discard.normalLimitSquared),
          READ_AS("taa", common.antialiasing.taa),
          READ_AS("taaNewestWeight", common.antialiasing.taaNewestWeight),
          READ_AS("taaJitteredWeight", common.antialiasing.taaJitteredWeight),
          READ_AS("taaSilhouetteWeight", common.antialiasing.taaSilhouetteWeight),
          READ_AS("antialiasLinear", common.antialiasing.antialiasLinear),
          READ_AS("jitteredRays", common.antialiasing.jitteredRays),
          READ_AS("toneMap", common.display.toneMap),
          READ_AS("displayEncoding", common.display.encoding),
          READ_AS("exposure", common.display.exposure)};
}

const Readers<QuellSettings> kQuell = {
    READ(historyFrames), READ(stillHistoryFrames), READ(momentsLeastWeight),    READ(temporalVarianceFrames),
    READ(mostWeight),    READ(changeThreshold),    READ(recentChangeThreshold), READ(changeGain),
    READ(changeMemory),  READ(sharpRoughness),     READ(prefilteredIterations), READ(prefilteredSigma),
    READ(keepLight),     READ(fireflyRatio)};
const Readers<BmfrSettings> kBmfr = {READ(noisyLeastWeight), READ(filteredLeastWeight),
                                     READ(noiseAmplitude),   READ(solver),
                                     READ(windows),          READ_AS("tileSize", tileSize / 8 - 1),
                                     READ(featureStorage),   READ(fireflyRatio)};
const Readers<SvgfSettings> kSvgf = {
    READ(irradianceLeastWeight),  READ(momentsLeastWeight), READ(feedback),
    READ(temporalVarianceFrames), READ(keepLight),          READ(fireflyRatio)};
const Readers<EdagiSettings> kEdagi = {READ_AS("hysteresis", history.hysteresis),
                                       READ_AS("meanFirst", history.meanFirst),
                                       READ_AS("nearFootprints", history.nearFootprints),
                                       READ_AS("farFootprints", history.farFootprints),
                                       READ_AS("nearDistance", history.nearDistance),
                                       READ_AS("farDistance", history.farDistance),
                                       READ_AS("clampSigma", history.clampSigma),
                                       READ(historyRadiusShare),
                                       READ(suppressFireflies),
                                       READ(radiusShare),
                                       READ(lowConfidenceFactor),
                                       READ(glossySigma),
                                       READ_AS("depthSigma", stops.depthSigma),
                                       READ_AS("normalPower", stops.normalPower),
                                       READ_AS("roughnessSigma", stops.roughnessSigma)};
const Readers<GuidedSettings> kGuided = {READ(irradianceLeastWeight), READ(fireflyRatio), READ(radius),
                                         READ(epsilon), READ_AS("subsampling", subsampling / 2 - 1)};
const Readers<AtrousSettings> kAtrous = {READ(skip), READ(demodulate), READ_AS("toneMap", display.toneMap),
                                         READ_AS("displayEncoding", display.encoding),
                                         READ_AS("exposure", display.exposure)};

template <class S>
void checkValues(const SettingTable<S>& table, const Readers<S>& readers, const Settings& settings) {
  const S values = table.resolve(settings);
  for (const Reader<S>& reader : readers) {
    INFO(reader.name);
    CHECK(reader.read(values) == settings.get(reader.name));
  }
}

template <class S>
void checkTable(const std::string& method, const SettingTable<S>& table, const Readers<S>& readers) {
  checkValues(table, readers, Settings(method));
  std::size_t texts = 0;
  for (const SettingDescription& setting : methodSettings(method)) {
    INFO(method << "." << setting.name);
    Settings settings(method);
    if (setting.kind == SettingKind::Text) ++texts;
    if (setting.kind == SettingKind::Text) continue;
    for (const double value : {setting.minimum, setting.maximum}) {
      settings.set(setting.name, value);
      checkValues(table, readers, settings);
    }
  }
  CHECK(readers.size() + texts == methodSettings(method).size());
}

RuntimeSettings runtimeOf(const Settings& settings) {
  return findMethod(settings.method()).runtimeSettings(settings);
}

}  // namespace

TEST_CASE("every setting arrives in a member of its own", "[core]") {
  checkTable("quell", quellSettings(),
             kQuell + filterReaders<QuellSettings>() + commonReaders<QuellSettings>());
  checkTable("bmfr", bmfrSettings(), kBmfr + commonReaders<BmfrSettings>());
  checkTable("svgf", svgfSettings(), kSvgf + filterReaders<SvgfSettings>() + commonReaders<SvgfSettings>());
  checkTable("edagi", edagiSettings(), kEdagi + commonReaders<EdagiSettings>());
  checkTable("guided", guidedSettings(), kGuided + commonReaders<GuidedSettings>());
  checkTable("atrous", atrousSettings(), kAtrous + filterReaders<AtrousSettings>());
}

TEST_CASE("choices, texts and numbers arrive as what they stand for", "[core]") {
  Settings settings("bmfr");
  settings.set("solver", "gram");
  settings.set("windows", "overlap");
  settings.set("tileSize", "16");
  settings.set("featureStorage", "half");
  settings.set("features", "n,w");
  const BmfrSettings bmfr = bmfrSettings().resolve(settings);
  CHECK(bmfr.solver == Solver::Gram);
  CHECK(bmfr.windows == Windows::Overlap);
  CHECK(bmfr.tileSize == 16);
  CHECK(bmfr.featureStorage == FeatureStorage::Half);
  CHECK(bmfr.features.names() == FitFeatures("n,w").names());
  CHECK(bmfrSettings().resolve(Settings("bmfr")).features.names() == FitFeatures().names());
}

TEST_CASE("the papers' values arrive", "[core]") {
  Settings bmfr("bmfr");
  bmfr.usePreset("paper");
  CHECK(bmfrSettings().resolve(bmfr).fireflyRatio == 0.0);
  Settings settings("svgf");
  settings.usePreset("paper");
  checkValues(svgfSettings(), kSvgf + filterReaders<SvgfSettings>() + commonReaders<SvgfSettings>(),
              settings);
  CHECK(svgfSettings().resolve(settings).feedback == Feedback::First);
  CHECK(svgfSettings().resolve(settings).stops.roughnessSigma == 0.0);
}

TEST_CASE("every setting refuses what is just out of its range", "[core]") {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (const std::string& method : methodNames()) {
    for (const SettingDescription& setting : methodSettings(method)) {
      if (setting.kind == SettingKind::Text) continue;
      Settings settings(method);
      INFO(method << "." << setting.name);
      const bool real = setting.kind == SettingKind::Real;
      const double below = real ? std::nextafter(setting.minimum, -infinity) : setting.minimum - 1.0;
      const double above = real ? std::nextafter(setting.maximum, infinity) : setting.maximum + 1.0;
      for (const double value : {below, above})
        CHECK_THROWS_MATCHES(settings.set(setting.name, value), Error,
                             failsWith(ErrorCode::OutOfRange, {setting.name}));
      if (!real)
        CHECK_THROWS_MATCHES(settings.set(setting.name, setting.minimum + 0.5), Error,
                             failsWith(ErrorCode::OutOfRange, {setting.name}));
      CHECK(settings.text(setting.name) == Settings(method).text(setting.name));
    }
  }
}

TEST_CASE("values of another method are refused", "[core]") {
  CHECK_THROWS_MATCHES(svgfSettings().resolve(Settings("atrous")), Error,
                       failsWith(ErrorCode::UnknownSetting, {"irradianceLeastWeight", "atrous"}));
}

TEST_CASE("the runtime is told what light is divided by", "[core]") {
  for (const std::string& method : methodNames()) {
    Settings settings(method);
    CHECK(runtimeOf(settings).demodulation == Demodulation::Albedo);
    settings.set("demodulate", "none");
    CHECK(runtimeOf(settings).demodulation == Demodulation::None);
    settings.set("demodulate", "fbeta");
    CHECK(runtimeOf(settings).demodulation == Demodulation::FBeta);
  }
}

TEST_CASE("the runtime is told when history is discarded", "[core]") {
  for (const char* method : {"quell", "bmfr", "svgf"}) {
    Settings settings(method);
    DiscardLimits limits = runtimeOf(settings).discard;
    CHECK(limits.position == 0.0);
    CHECK(limits.positionFootprints == 8.0);
    CHECK(limits.normalSquared == 0.1);
    settings.set("positionLimit", 0.25);  // replaces the footprints
    settings.set("normalLimitSquared", 0.5);
    limits = runtimeOf(settings).discard;
    CHECK(limits.position == 0.25);
    CHECK(limits.positionFootprints == 0.0);
    CHECK(limits.normalSquared == 0.5);
  }
}

}  // namespace quell::tests
