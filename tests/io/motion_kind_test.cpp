#include "host/io/motion_kind.hpp"

#include <catch2/catch.hpp>

#include "tests/support/error_matcher.hpp"

using namespace quell::io;
using quell::Error;
using quell::ErrorCode;
using quell::tests::failsWith;

TEST_CASE("kinds of motion are words, and text that says them again") {
  for (const char* text : {"ndc", "uv/y-up/from-previous", "y-up", "from-previous"})
    CHECK(toString(parseMotionKind(text)) == text);
  CHECK(toString(parseMotionKind("to-previous/px/y-down")) == "");
  for (const char* text : {"", "up", "uv/", "uv,y-up", "UV"})
    CHECK_THROWS_MATCHES(parseMotionKind(text), Error,
                         failsWith(ErrorCode::InvalidArgument, {"px, ndc, uv, y-down, y-up", text}));
}

TEST_CASE("motion of any kind becomes that of the contract") {
  const auto turned = [](const char* kind) {
    Image motion(1, 1, 2);
    motion.pixels = {0.5f, 0.25f};
    toContract(motion, parseMotionKind(kind), 200, 100);
    return motion.pixels;
  };
  CHECK(turned("px") == std::vector<float>{0.5f, 0.25f});
  CHECK(turned("y-up") == std::vector<float>{0.5f, -0.25f});
  CHECK(turned("uv") == std::vector<float>{100.0f, 25.0f});
  CHECK(turned("ndc/y-up/from-previous") == std::vector<float>{-50.0f, 12.5f});
}
