// Settings: defaults, values by number and by text, and what is refused.
#include <catch2/catch.hpp>
#include <limits>
#include <quell/settings.hpp>

#include "tests/support/error_matcher.hpp"
#include "tests/support/small_denoiser.hpp"

namespace quell::tests {

TEST_CASE("settings start at documented defaults that are within their own range", "[core]") {
  for (const std::string& method : methodNames()) {
    CHECK_FALSE(methodSummary(method).empty());
    Settings settings(method);
    CHECK(settings.method() == method);
    for (const SettingDescription& setting : settings.descriptions()) {
      INFO(method << "." << setting.name);
      if (setting.kind == SettingKind::Text) {
        CHECK(settings.text(setting.name) == setting.defaultText);
        CHECK_NOTHROW(settings.set(setting.name, setting.defaultText));
        continue;
      }
      CHECK(settings.get(setting.name) == setting.defaultValue);
      CHECK(setting.minimum <= setting.defaultValue);
      CHECK(setting.defaultValue <= setting.maximum);
      CHECK_FALSE(setting.description.empty());
      CHECK_FALSE(setting.source.empty());
      if (setting.kind == SettingKind::Choice)
        CHECK(setting.choices.size() == std::size_t(setting.maximum) + 1);
      CHECK_NOTHROW(settings.set(setting.name, setting.minimum));
      CHECK_NOTHROW(settings.set(setting.name, setting.maximum));
    }
  }
}

TEST_CASE("every setting's text reads back as the same value", "[core]") {
  Settings settings, copy;
  for (const SettingDescription& setting : settings.descriptions()) {
    if (setting.kind == SettingKind::Text) continue;
    if (setting.kind == SettingKind::Real)
      settings.set(setting.name, setting.minimum + (setting.maximum - setting.minimum) / 3.0);
    else
      settings.set(setting.name, setting.maximum);
    INFO(setting.name << " = " << settings.text(setting.name));
    copy.set(setting.name, settings.text(setting.name));
    CHECK(copy.get(setting.name) == settings.get(setting.name));
  }
}

TEST_CASE("settings are set by number and by text", "[core]") {
  Settings settings("bmfr");
  settings.set("noisyLeastWeight", 0.25);
  CHECK(settings.get("noisyLeastWeight") == 0.25);
  settings.set("noisyLeastWeight", "0.125");
  CHECK(settings.get("noisyLeastWeight") == 0.125);
  CHECK(settings.text("noisyLeastWeight") == "0.125");
  settings.set("positionLimit", "1e3");
  CHECK(settings.get("positionLimit") == 1000.0);
}

TEST_CASE("a text keeps what it was given and has no number", "[core]") {
  Settings settings("bmfr");
  settings.set("features", "nx, 1");
  CHECK(settings.text("features") == "nx, 1");
  CHECK(settings.get("features") == 0.0);
  checkRefused({ErrorCode::OutOfRange, "settings", "features", "a text", "3"},
               [&] { settings.set("features", 3.0); });
  checkRefused({ErrorCode::OutOfRange, "settings", "features", "a list", "magic"},
               [&] { settings.set("features", "magic"); });
  CHECK(settings.text("features") == "nx, 1");
}

TEST_CASE("switches take on, off, true, false, 1 and 0", "[core]") {
  Settings settings("bmfr");
  for (const char* on : {"on", "true", "1"}) {
    settings.set("taa", 0.0);
    settings.set("taa", on);
    CHECK(settings.isOn("taa"));
    CHECK(settings.text("taa") == "on");
  }
  for (const char* off : {"off", "false", "0"}) {
    settings.set("taa", 1.0);
    settings.set("taa", off);
    CHECK_FALSE(settings.isOn("taa"));
    CHECK(settings.text("taa") == "off");
  }
  REQUIRE_THROWS_MATCHES(settings.set("taa", 0.5), Error,
                         failsWith(ErrorCode::OutOfRange, {"taa", "on or off", "0.5"}));
  REQUIRE_THROWS_MATCHES(settings.set("taa", "maybe"), Error,
                         failsWith(ErrorCode::OutOfRange, {"taa", "on or off", "maybe"}));
}

TEST_CASE("choices are taken by name", "[core]") {
  Settings settings("bmfr");
  settings.set("featureStorage", "half");
  CHECK(settings.get("featureStorage") == 1.0);
  CHECK(settings.text("featureStorage") == "half");
  REQUIRE_THROWS_MATCHES(settings.set("featureStorage", "double"), Error,
                         failsWith(ErrorCode::OutOfRange, {"featureStorage", "float, half", "double"}));
  REQUIRE_THROWS_MATCHES(settings.set("featureStorage", 2.0), Error,
                         failsWith(ErrorCode::OutOfRange, {"featureStorage", "float, half", "2"}));
  CHECK(settings.text("featureStorage") == "half");
}

TEST_CASE("an unknown name is refused with the names there are", "[core]") {
  Settings settings("bmfr");
  const auto refusal =
      failsWith(ErrorCode::UnknownSetting, {"taaWeight", "bmfr", "noisyLeastWeight", "taaNewestWeight"});
  REQUIRE_THROWS_MATCHES(settings.set("taaWeight", 0.5), Error, refusal);
  REQUIRE_THROWS_MATCHES(settings.set("taaWeight", "0.5"), Error, refusal);
  REQUIRE_THROWS_MATCHES(settings.get("taaWeight"), Error, refusal);
  REQUIRE_THROWS_MATCHES(settings.text("taaWeight"), Error, refusal);
  REQUIRE_THROWS_MATCHES(
      settings.set("noisyleastweigth", 0.5), Error,
      failsWith(ErrorCode::UnknownSetting, {"perhaps noisyLeastWeight; a setting of bmfr"}));
  try {
    settings.set("magic", 1.0);
  } catch (const Error& error) {
    CHECK(error.expected().find("perhaps") == std::string::npos);
  }
  REQUIRE_THROWS_MATCHES(Settings("svdf"), Error,
                         failsWith(ErrorCode::UnknownSetting, {"method", "bmfr", "svdf"}));
  REQUIRE_THROWS_MATCHES(methodSummary(""), Error, failsWith(ErrorCode::UnknownSetting, {"bmfr"}));
}

TEST_CASE("a value out of range is refused with the range and leaves the old one", "[core]") {
  Settings settings("bmfr");
  const double before = settings.get("noisyLeastWeight");
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double value : {1.0001, 0.0, -1.0, infinity, -infinity, nan})
    REQUIRE_THROWS_MATCHES(settings.set("noisyLeastWeight", value), Error,
                           failsWith(ErrorCode::OutOfRange, {"noisyLeastWeight", "0.001 to 1"}));
  for (const char* text : {"", "x", "0.5x", "0.5 0.5", "nan", "inf", "2", "-0.5"})
    REQUIRE_THROWS_MATCHES(settings.set("noisyLeastWeight", text), Error,
                           failsWith(ErrorCode::OutOfRange, {"noisyLeastWeight", "0.001 to 1"}));
  CHECK(settings.get("noisyLeastWeight") == before);
  REQUIRE_THROWS_MATCHES(settings.set("positionLimitFootprints", -1.0), Error,
                         failsWith(ErrorCode::OutOfRange, {"0 to 1000000 pixel footprints", "-1"}));
  Settings quell;
  REQUIRE_THROWS_MATCHES(quell.set("historyFrames", "900"), Error,
                         failsWith(ErrorCode::OutOfRange, {"1 to 255", "got 900"}));
}

TEST_CASE("a preset sets what it has a value for", "[core]") {
  for (const std::string& method : methodNames()) {
    Settings settings(method);
    for (const SettingDescription& setting : settings.descriptions())
      if (setting.kind != SettingKind::Text) settings.set(setting.name, setting.maximum);
    settings.usePreset("paper");
    for (const SettingDescription& setting : settings.descriptions()) {
      INFO(method << "." << setting.name);
      if (setting.paper) {
        CHECK(settings.get(setting.name) == *setting.paper);
        CHECK(setting.minimum <= *setting.paper);
        CHECK(*setting.paper <= setting.maximum);
      } else if (setting.kind != SettingKind::Text) {
        CHECK(settings.get(setting.name) == setting.maximum);
      }
    }
    settings.usePreset("default");
    for (const SettingDescription& setting : settings.descriptions())
      CHECK(settings.text(setting.name) == Settings(method).text(setting.name));
  }
}

TEST_CASE("the paper's svgf can be had by name", "[core]") {
  Settings settings("svgf");
  settings.usePreset("paper");
  CHECK(settings.get("irradianceLeastWeight") == 0.2);
  CHECK(settings.get("momentsLeastWeight") == 0.2);
  CHECK(settings.get("luminanceSigma") == 4.0);
  CHECK(settings.get("normalPower") == 128.0);
  CHECK(settings.get("depthSigma") == 1.0);
  CHECK(settings.get("iterations") == 5.0);
  CHECK(settings.get("temporalVarianceFrames") == 4.0);
  CHECK(settings.text("feedback") == "first");
}

TEST_CASE("an unknown preset is refused and changes nothing", "[core]") {
  Settings settings("svgf");
  settings.set("iterations", 3.0);
  REQUIRE_THROWS_MATCHES(settings.usePreset("papr"), Error,
                         failsWith(ErrorCode::UnknownSetting, {"preset", "default or paper", "papr"}));
  CHECK(settings.get("iterations") == 3.0);
}

TEST_CASE("every method can leave light undivided", "[core]") {
  for (const std::string& method : methodNames()) {
    Settings settings(method);
    CHECK(settings.text("demodulate") == "albedo");
    settings.set("demodulate", "none");
    CHECK(settings.text("demodulate") == "none");
    REQUIRE_THROWS_MATCHES(settings.set("demodulate", "gloss"), Error,
                           failsWith(ErrorCode::OutOfRange, {"demodulate", "none", "albedo", "gloss"}));
  }
}

}  // namespace quell::tests
