#include "host/io/c_header_values.hpp"

#include <catch2/catch.hpp>

#include "tests/support/error_matcher.hpp"

using quell::Error;
using quell::ErrorCode;
using quell::io::CHeaderValues;
using quell::tests::failsWith;

TEST_CASE("constants are found as variables and as macros") {
  const CHeaderValues header(
      "#define A 0.25f\nstatic const float b = -1.5e-3f; /* b = 7 */ // b = 8\n"
      "const int ab=3u;\n#define C (+2.)\nconst float d = .5f;",
      "x.h");
  REQUIRE(header.constant("A").value() == 0.25);
  REQUIRE(header.constant("b").value() == -1.5e-3);
  REQUIRE(header.constant("ab").value() == 3.0);
  REQUIRE(header.constant("C").value() == 2.0);
  REQUIRE(header.constant("d").value() == 0.5);
  REQUIRE_FALSE(header.constant("a").has_value());
}

TEST_CASE("arrays are read in order, however the braces nest") {
  const CHeaderValues header(
      "// values[2] = {9};\nconst float values[2][2] = {\n {1.0f, 2.f}, // one = {\n {-3, 4e1f,},\n};\n"
      "double flat[] = {1, 2};",
      "x.h");
  REQUIRE(header.array("values").value() == std::vector<double>{1.0, 2.0, -3.0, 40.0});
  REQUIRE(header.array("flat").value() == std::vector<double>{1.0, 2.0});
  REQUIRE_FALSE(header.array("alues").has_value());
}

TEST_CASE("what is not a number is refused by name") {
  const auto refused = failsWith(ErrorCode::FileError, {"x.h", "v followed by"});
  for (const char* text : {"v = {1, two};", "v = {1, 2", "v = 3;", "v[2];", "v", "v = {0x1};", "v = {nan};",
                           "v = {1e999};", "v = {1..2};", "v = {1 /* };"})
    REQUIRE_THROWS_MATCHES(CHeaderValues(text, "x.h").array("v"), Error, refused);
  for (const char* text : {"v = w;", "v", "v =", "#define v 1.0q"})
    REQUIRE_THROWS_MATCHES(CHeaderValues(text, "x.h").constant("v"), Error, refused);
}
