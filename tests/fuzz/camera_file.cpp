// camera.json.
#include "host/io/camera_file.hpp"

#include "tests/fuzz/reader.hpp"

namespace quell::fuzz {
namespace {

void read(const std::uint8_t* bytes, std::size_t count) {
  const std::string path = asFile(bytes, count, "camera.json");
  attempt([&] { io::readCameraFile(path, 16.0 / 9.0); });
}

const Reader kReader("camera_file", read);

}  // namespace
}  // namespace quell::fuzz
