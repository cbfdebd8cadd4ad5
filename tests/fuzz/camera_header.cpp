// camera_matrices.h of the layout published with the BMFR paper.
#include "host/io/c_header_values.hpp"
#include "tests/fuzz/reader.hpp"

namespace quell::fuzz {
namespace {

void read(const std::uint8_t* bytes, std::size_t count) {
  const std::string text(reinterpret_cast<const char*>(bytes), count);
  attempt([&] { io::CHeaderValues(text, "header").array("camera_matrices"); });
  attempt([&] { io::CHeaderValues(text, "header").array("pixel_offsets"); });
  attempt([&] { io::CHeaderValues(text, "header").constant("position_limit_squared"); });
}

const Reader kReader("camera_header", read);

}  // namespace
}  // namespace quell::fuzz
