// Captured frames: files as they are, and their lines with a checksum that is right.
#include "host/api/captured_frame.hpp"
#include "host/api/captured_lines.hpp"
#include "host/core/fnv1a.hpp"
#include "tests/fuzz/reader.hpp"

namespace quell::fuzz {
namespace {

void readBoth(const std::string& path) {
  attempt([&] { readFrame(path); });
  attempt([&] { readFacts(path); });
}

void read(const std::uint8_t* bytes, std::size_t count) {
  readBoth(asFile(bytes, count, "captured"));
  std::string lines(bytes, bytes + count);
  lines += "\n";
  lines += "end " + hashText(fnv1a(lines.data(), lines.size())) + "\n";
  readBoth(asFile(reinterpret_cast<const std::uint8_t*>(lines.data()), lines.size(), "lines"));
}

const Reader kReader("capture", read);

}  // namespace
}  // namespace quell::fuzz
