// Pictures that quell compare reads besides OpenEXR: PNG, PFM, raw samples.
#include "host/io/plain_image.hpp"
#include "host/io/png_image.hpp"
#include "tests/fuzz/reader.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
  using namespace quell;
  const std::string path = fuzz::asFile(bytes, count, "picture");
  fuzz::attempt([&] { io::readPng(path); });
  fuzz::attempt([&] { io::readPfm(path); });
  fuzz::attempt([&] { io::readRaw(path, 2, 2); });
  return 0;
}
