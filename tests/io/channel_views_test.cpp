#include "host/io/channel_views.hpp"

#include <catch2/catch.hpp>

#include "tests/support/error_matcher.hpp"

using namespace quell::io;
using quell::Error;
using quell::ErrorCode;
using quell::tests::failsWith;

TEST_CASE("channels of a view lose its name") {
  const std::vector<std::string> channels = {"L.Combined.left.R", "L.Combined.right.R", "left.Z", "right.Z",
                                             "id.X"};
  const ViewChannels right = channelsOfView("a.exr", channels, {}, "right");
  CHECK(right.view == "right");
  CHECK(right.stored == std::map<std::string, std::string>{
                            {"L.Combined.R", "L.Combined.right.R"}, {"Z", "right.Z"}, {"id.X", "id.X"}});
  CHECK_THROWS_MATCHES(channelsOfView("a.exr", channels, {}, ""), Error,
                       failsWith(ErrorCode::FileError, {"a.exr", "--view NAME", "left, right"}));
  CHECK_THROWS_MATCHES(channelsOfView("a.exr", channels, {}, "main"), Error,
                       failsWith(ErrorCode::FileError, {"the view main", "left, right"}));
}

TEST_CASE("channels without a view are of the first one that a header declares") {
  const std::vector<std::string> channels = {"R", "far.R", "albedo.R"};
  CHECK(channelsOfView("a.exr", channels, {"near", "far"}, "near").stored ==
        std::map<std::string, std::string>{{"R", "R"}, {"albedo.R", "albedo.R"}});
  CHECK(channelsOfView("a.exr", channels, {"near", "far"}, "far").stored ==
        std::map<std::string, std::string>{{"R", "far.R"}});
}

TEST_CASE("files without views have no view") {
  const ViewChannels all = channelsOfView("a.exr", {"R", "N.X"}, {}, "");
  CHECK(all.view.empty());
  CHECK(all.stored.size() == 2);
  CHECK_THROWS_MATCHES(channelsOfView("a.exr", {"R"}, {}, "left"), Error,
                       failsWith(ErrorCode::FileError, {"the view left", "no views"}));
}
