// quell select-features as a user runs it.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/support/temporary_directory.hpp"
#include "tests/support/tool.hpp"

namespace quell::tests {
namespace {

int select(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), "select-features");
  return quell(arguments);
}

}  // namespace

TEST_CASE("select-features adds what lowers the error the most", "[cli]") {
  const TemporaryDirectory directory;
  const std::string json = directory.path() + "/steps.json";
  REQUIRE(select({"--input", kData, "--pool", "1,n,w,w2", "--count", "7", "--json", json}) == 0);
  const auto steps = readJson(json);
  REQUIRE(steps.size() == 3);  // three scalars a step, from 1 to 7
  CHECK(steps[0].at("features") == "1");
  CHECK(steps[0].at("added") == "");
  for (std::size_t i = 1; i < steps.size(); ++i) {
    const double before = steps[i - 1].at("unbiased_rmse").get<double>();
    const double rmse = steps[i].at("unbiased_rmse").get<double>();
    CHECK(rmse > 0.0);
    CHECK(rmse < before);
    CHECK(steps[i].at("gain").get<double>() == Approx(1.0 - rmse / before));
    CHECK(steps[i].at("count") == 1 + 3 * i);
  }
  CHECK(steps[1].at("added") != steps[2].at("added"));

  // Whichever was first must beat what was passed over.
  const std::string other = steps[1].at("added") == "n" ? "w" : "n";
  const std::string json2 = directory.path() + "/other.json";
  REQUIRE(select({"--input", kData, "--pool", other, "--json", json2}) == 0);
  const auto otherSteps = readJson(json2);
  CHECK(otherSteps.back().at("unbiased_rmse").get<double>() >= steps[1].at("unbiased_rmse").get<double>());
}

TEST_CASE("select-features takes groups apart where asked to", "[cli]") {
  const TemporaryDirectory directory;
  const std::string json = directory.path() + "/steps.json";
  REQUIRE(select({"--input", kData, "--pool", "n", "--components", "--count", "2", "--json", json, "--solver",
                  "householder"}) == 0);
  const auto steps = readJson(json);
  REQUIRE(steps.size() == 2);
  CHECK(steps[1].at("count") == 2);
}

TEST_CASE("select-features answers mistakes", "[cli]") {
  CHECK(select({}) != 0);
  CHECK(select({"--input", kData, "--pool", "magic"}) == 1);
  CHECK(select({"--input", kData, "--start", "n,n"}) == 1);
  CHECK(select({"--input", kData, "--start", "n,w", "--count", "3"}) == 1);
  CHECK(select({"--input", kData, "--count", "17"}) != 0);
  CHECK(select({"--input", kData, "--pool", "roughness"}) == 1);  // data/colonnade has no such image
}

}  // namespace quell::tests
