// OpenEXR files: header, samples, and as a frame with all passes.
#include "host/io/exr_image.hpp"
#include "host/io/frame_sequence.hpp"
#include "tests/fuzz/reader.hpp"

namespace quell::fuzz {
namespace {

void read(const std::uint8_t* bytes, std::size_t count) {
  const std::string path = asFile(bytes, count, "frame_0001.exr");
  attempt([&] {
    const io::ExrHeader header = io::readExrHeader(path);
    // What the header claims is checked against the file's length, not against this: large pictures are slow here.
    constexpr long kMostPixels = 1 << 16;
    if (static_cast<long>(header.width) * header.height > kMostPixels) return;
    attempt([&] { io::readExr(path); });
    attempt([&] { io::readExr(path, {header.channels.front()}); });
    attempt([&] {
      const auto sequence = io::openSequence(path);
      sequence->read(sequence->frames().front());
    });
  });
}

const Reader kReader("exr", read);

}  // namespace
}  // namespace quell::fuzz
