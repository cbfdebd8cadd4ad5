#include "host/io/ray_depth.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "host/io/multilayer_camera.hpp"
#include "tests/support/multilayer_files.hpp"

using namespace quell::io;
using namespace quell::tests;

TEST_CASE("a camera follows from positions and distances along rays") {
  const FrameData frame = multilayer::builtIn()->read(1);
  const Image view = multilayer::depthOf(frame);
  // Distance over view depth is the tangent length of the pixel's ray; the eye is where all rays meet.
  const auto& m = frame.camera.worldToClip;
  for (const double start : {0.0, 0.05}) {
    Image rays = view;
    for (int y = 0; y < multilayer::kHeight; ++y)
      for (int x = 0; x < multilayer::kWidth; ++x) {
        if (multilayer::isSky(frame, x, y)) continue;
        const double unit = std::sqrt(m[12] * m[12] + m[13] * m[13] + m[14] * m[14]);
        const double scaleX = std::sqrt(m[0] * m[0] + m[1] * m[1] + m[2] * m[2]) / unit;
        const double scaleY = std::sqrt(m[4] * m[4] + m[5] * m[5] + m[6] * m[6]) / unit;
        const double tangentX = ((2.0 * x + 1.0) / multilayer::kWidth - 1.0) / scaleX;
        const double tangentY = (1.0 - (2.0 * y + 1.0) / multilayer::kHeight) / scaleY;
        rays.at(x, y, 0) =
            float(view.at(x, y, 0) * std::sqrt(1.0 + tangentX * tangentX + tangentY * tangentY) - start);
      }
    rays.at(20, 30, 0) = 1000.0f;  // one bad pixel
    const auto depth = viewDepthFromRays(frame.positionWorld, rays);
    REQUIRE(depth);
    const FoundCamera found = findCamera(frame.positionWorld, *depth);
    REQUIRE(found.worldToClip);
    CHECK(multilayer::projectionError(*found.worldToClip, m, frame) < 0.05);
  }
}

TEST_CASE("no view depth follows from the sky, or from one point") {
  const Image sky(4, 4, 1, 1e10f);
  CHECK_FALSE(viewDepthFromRays(Image(4, 4, 3), sky));
  CHECK_FALSE(viewDepthFromRays(Image(4, 4, 3, 1.0f), Image(4, 4, 1, 2.0f)));
}
