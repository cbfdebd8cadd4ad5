// Entries of the cache of kernels, and the tuning of a device, which is kept as one.
#include "host/core/disk_cache.hpp"
#include "host/core/tuning.hpp"
#include "tests/fuzz/reader.hpp"

namespace quell::fuzz {
namespace {

void read(const std::uint8_t* bytes, std::size_t count) {
  namespace fs = std::filesystem;
  const std::string directory = (directoryOfFiles() / "cache").string();
  const DiskCache disk(directory);
  // The text of a tuning within an intact entry, then an entry that is these bytes.
  writeTuning(disk, "device", {});
  std::string entry;
  for (const auto& file : fs::directory_iterator(directory)) entry = file.path().string();
  disk.write("quell tuning 1\ndevice", DiskCache::Bytes(bytes, bytes + count));
  readTuning(disk, "device");
  if (!entry.empty()) writeFile(entry, bytes, count);
  readTuning(disk, "device");
}

const Reader kReader("cache", read);

}  // namespace
}  // namespace quell::fuzz
