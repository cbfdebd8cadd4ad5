// camera.json.
#include "host/io/camera_file.hpp"

#include "tests/fuzz/reader.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
  using namespace quell;
  const std::string path = fuzz::asFile(bytes, count, "camera.json");
  fuzz::attempt([&] { io::readCameraFile(path, 16.0 / 9.0); });
  return 0;
}
