// Pictures that quell compare reads besides OpenEXR: PNG, PFM, raw samples.
#include "host/io/plain_image.hpp"
#include "host/io/png_image.hpp"
#include "tests/fuzz/reader.hpp"

namespace quell::fuzz {
namespace {

void read(const std::uint8_t* bytes, std::size_t count) {
  const std::string path = asFile(bytes, count, "picture");
  attempt([&] { io::readPng(path); });
  attempt([&] { io::readPfm(path); });
  attempt([&] { io::readRaw(path, 2, 2); });
}

const Reader kReader("picture", read);

}  // namespace
}  // namespace quell::fuzz
