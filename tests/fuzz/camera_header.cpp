// camera_matrices.h of the layout published with the BMFR paper.
#include "host/io/c_header_values.hpp"
#include "tests/fuzz/reader.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
  using namespace quell;
  const std::string text(reinterpret_cast<const char*>(bytes), count);
  fuzz::attempt([&] { io::CHeaderValues(text, "header").array("camera_matrices"); });
  fuzz::attempt([&] { io::CHeaderValues(text, "header").array("pixel_offsets"); });
  fuzz::attempt([&] { io::CHeaderValues(text, "header").constant("position_limit_squared"); });
  return 0;
}
