// The language of the setting `features`: names, groups, order, and what is refused.
#include "host/stages/fit_features.hpp"

#include <catch2/catch.hpp>

#include "tests/support/error_matcher.hpp"
#include "tests/support/small_denoiser.hpp"

namespace quell::tests {
namespace {

using Names = std::vector<std::string>;

Names namesOf(const std::string& list) { return FitFeatures(list).names(); }

void checkRefusedList(const std::string& list, const std::string& expected, const std::string& got) {
  INFO(list);
  checkRefused({ErrorCode::OutOfRange, "settings", "features", expected, got},
               [&] { Settings("bmfr").set("features", list); });
}

}  // namespace

TEST_CASE("the default features are those of the paper", "[core]") {
  CHECK(Settings("bmfr").text("features") == "1,n,w,w2");
  CHECK(FitFeatures().names() == Names{"1", "nx", "ny", "nz", "wx", "wy", "wz", "wx2", "wy2", "wz2"});
  CHECK(FitFeatures().scaledNames() == Names{"wx", "wy", "wz"});
  CHECK_FALSE(FitFeatures().needMaterial());
}

TEST_CASE("the constant is implied and comes first", "[core]") {
  CHECK(namesOf("1") == Names{"1"});
  CHECK(namesOf("nx") == Names{"1", "nx"});
  CHECK(namesOf("nx, 1 ,ny") == Names{"1", "nx", "ny"});
}

TEST_CASE("groups, powers, roots, products and differences are taken apart", "[core]") {
  CHECK(namesOf("n^2") == Names{"1", "nx2", "ny2", "nz2"});
  CHECK(namesOf("wx*wx,wy^3") == Names{"1", "wx2", "wy3"});
  CHECK(namesOf("sqrt(n)") == Names{"1", "sqrt(nx)", "sqrt(ny)", "sqrt(nz)"});
  CHECK(namesOf("ny*wx") == Names{"1", "wx*ny"});
  CHECK(namesOf("w*w") == Names{"1", "wx*wy", "wx*wz", "wy*wz"});
  CHECK(namesOf("w*n").size() == 10);
  CHECK(namesOf("w-w") == Names{"1", "wx-wy", "wx-wz", "wy-wz"});
  CHECK(namesOf("wz-wx") == Names{"1", "wx-wz"});
  CHECK(namesOf("albedo,roughness,g,depth") ==
        Names{"1", "ar", "ag", "ab", "roughness", "gx", "gy", "depth"});
}

TEST_CASE("canonical names are a list of the same features", "[core]") {
  for (const char* list : {"n,w,w2,albedo,roughness,g", "wx3,wx2*ny,sqrt(wx)2,nx-ny,depth,sqrt(depth)"}) {
    std::string again;
    for (const std::string& name : namesOf(list)) again += (again.empty() ? "" : ",") + name;
    CHECK(namesOf(again) == namesOf(list));
  }
}

TEST_CASE("features need the images that they are made of", "[core]") {
  CHECK(FitFeatures("sqrt(ag)").needAlbedo());
  CHECK_FALSE(FitFeatures("ag").needRoughness());
  CHECK(FitFeatures("wx*roughness").needRoughness());
}

TEST_CASE("overlapping windows collect what a change of scaling brings in", "[core]") {
  CHECK(FitFeatures("wx2").gramNames(true) == Names{"1", "wx2", "wx"});
  CHECK(FitFeatures("wx2").gramNames(false) == Names{"1", "wx2"});
  CHECK(FitFeatures("wx*nx").gramNames(true) == Names{"1", "wx*nx", "nx"});
  CHECK(FitFeatures("wx*wy").gramNames(true) == Names{"1", "wx*wy", "wy", "wx"});
  CHECK(FitFeatures().gramNames(true) == FitFeatures().names());
}

TEST_CASE("lists that make no sense are refused", "[core]") {
  checkRefusedList("n,foo", "nx ny nz (n)", "foo");
  checkRefusedList("", "nx ny nz (n)", "an empty entry");
  checkRefusedList("n,,w", "nx ny nz (n)", "an empty entry");
  checkRefusedList("wx4", "nx ny nz (n)", "wx4");
  checkRefusedList("n,ny", "every feature once", "ny twice");
  checkRefusedList("1,n,1", "every feature once", "1 twice");
  checkRefusedList("wx*ny,ny*wx", "every feature once", "wx*ny twice");
  checkRefusedList("n,w,n2,w2,n3,w3", "at most 16 features", "19");
  checkRefusedList("wx2*wy2", "at most three factors", "wx2*wy2");
  // Multiplied out it would have 3^21 terms.
  std::string endless = "w";
  for (int i = 0; i < 10; ++i) endless += "*n*w";
  checkRefusedList(endless, "at most three factors", endless);
  checkRefusedList("sqrt(gx)", "roots of anything but gx and gy", "sqrt(gx)");
  checkRefusedList("wx-nx", "two components of n or of w", "wx-nx");
  checkRefusedList("wx-wx", "two different components", "wx-wx");
}

TEST_CASE("a feature whose image is missing is refused by prepare()", "[core]") {
  for (const char* image : {"albedo", "roughness"}) {
    SmallDenoiser small;
    Frame frame = small.buffers.frame;
    frame.albedo = {};
    Settings settings("bmfr");
    settings.set("features", image);
    const OpenDevice device;
    Denoiser denoiser(device.context, device.device, device.queue, settings);
    checkRefused({ErrorCode::InvalidArgument, "prepare", image, "an image", "none"},
                 [&] { denoiser.prepare(frame, small.buffers.output); });
  }
}

TEST_CASE("overlapping windows refuse lists whose lower powers are too many", "[core]") {
  SmallDenoiser small;
  Settings settings("bmfr");
  settings.set("features", "wx3,wy3,wz3,depth3,gx3,gy3,sqrt(wx)3,sqrt(wy)3,sqrt(wz)3,sqrt(depth)3");
  settings.set("solver", "gram");
  settings.set("windows", "overlap");
  const OpenDevice device;
  Denoiser denoiser(device.context, device.device, device.queue, settings);
  checkRefused({ErrorCode::OutOfRange, "settings", "features", "at most 24", "31"},
               [&] { denoiser.prepare(small.buffers.frame, small.buffers.output); });
}

}  // namespace quell::tests
