#include "host/io/base64.hpp"

#include <catch2/catch.hpp>

namespace quell::tests {

TEST_CASE("base64 encodes the test vectors of RFC 4648, section 10", "[io]") {
  CHECK(io::base64("").empty());
  CHECK(io::base64("f") == "Zg==");
  CHECK(io::base64("fo") == "Zm8=");
  CHECK(io::base64("foo") == "Zm9v");
  CHECK(io::base64("foob") == "Zm9vYg==");
  CHECK(io::base64("fooba") == "Zm9vYmE=");
  CHECK(io::base64("foobar") == "Zm9vYmFy");
}

TEST_CASE("base64 takes bytes of any value", "[io]") {
  CHECK(io::base64(std::string("\0\xff\xfe", 3)) == "AP/+");
}

}  // namespace quell::tests
