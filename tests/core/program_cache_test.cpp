// The program cache: memory, disk, damaged entries, several threads.
#include "host/core/program_cache.hpp"

#include <catch2/catch.hpp>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <thread>

#include "host/core/kernel_sources.hpp"
#include "tests/support/error_matcher.hpp"
#include "tests/support/small_denoiser.hpp"
#include "tests/support/temporary_directory.hpp"

namespace quell::tests {
namespace {

namespace fs = std::filesystem;
using Bytes = std::vector<char>;

// A program of its own for every test, so that counters tell what happened to it.
std::string storing(int value) {
  return "__kernel void store(__global int* out) { out[0] = " + std::to_string(value) + "; }\n";
}

// As on devices that give binaries for nothing, unless told otherwise.
cl::Program build(const OpenDevice& device, const std::string& directory, const std::string& source,
                  bool compilesForBinaries = false) {
  DeviceTraits traits = queryDeviceTraits(device.device, Mapping::Automatic);
  traits.compilesForBinaries = compilesForBinaries;
  return ProgramCache(directory).build(device.context, device.device, traits, "store", source, "");
}

int storedBy(const OpenDevice& device, const cl::Program& program) {
  const cl::Buffer buffer(device.context, CL_MEM_READ_WRITE, sizeof(cl_int));
  cl::Kernel kernel(program, "store");
  kernel.setArg(0, buffer);
  device.queue.enqueueNDRangeKernel(kernel, cl::NullRange, cl::NDRange(1), cl::NDRange(1));
  cl_int value = 0;
  device.queue.enqueueReadBuffer(buffer, CL_TRUE, 0, sizeof(value), &value);
  return value;
}

struct Step {
  int built, fromMemory, fromDisk;
};
bool operator==(const Step& a, const Step& b) {
  return a.built == b.built && a.fromMemory == b.fromMemory && a.fromDisk == b.fromDisk;
}
std::ostream& operator<<(std::ostream& stream, const Step& step) {
  return stream << step.built << " built, " << step.fromMemory << " from memory, " << step.fromDisk
                << " from disk";
}

// What the counters gain while `work` runs.
Step stepOf(const std::function<void()>& work) {
  const ProgramCacheCounters before = ProgramCache::counters();
  work();
  const ProgramCacheCounters after = ProgramCache::counters();
  return {after.built - before.built, after.fromMemory - before.fromMemory, after.fromDisk - before.fromDisk};
}

constexpr Step kBuilt{1, 0, 0}, kFromMemory{0, 1, 0}, kFromDisk{0, 0, 1};

// Where the program came from when a process starts anew; checks that it is the right one.
Step afterRestart(const OpenDevice& device, const std::string& directory, int value) {
  ProgramCache::clearMemory();
  return stepOf([&] { CHECK(storedBy(device, build(device, directory, storing(value))) == value); });
}

fs::path onlyFile(const std::string& directory) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(directory)) files.push_back(entry.path());
  REQUIRE(files.size() == 1);
  return files.front();
}

Bytes readFile(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return Bytes((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
}

void writeFile(const fs::path& path, const Bytes& bytes) {
  std::ofstream(path, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

// The line of a kernel header that holds `text`.
int lineOf(const std::string& header, const std::string& text) {
  std::ifstream file(std::string(QUELL_KERNEL_DIR) + "/" + header);
  int number = 1;
  for (std::string line; std::getline(file, line); ++number)
    if (line.find(text) != std::string::npos) return number;
  return -1;
}

}  // namespace

TEST_CASE("a program is compiled once per process", "[core]") {
  const OpenDevice device, other;
  CHECK(stepOf([&] { build(device, "", storing(101)); }) == kBuilt);
  CHECK(stepOf([&] { CHECK(storedBy(device, build(device, "", storing(101))) == 101); }) == kFromMemory);
  CHECK(stepOf([&] { CHECK(storedBy(other, build(other, "", storing(101))) == 101); }) == kFromMemory);
  CHECK(afterRestart(device, "", 101) == kBuilt);
}

TEST_CASE("a program is read from disk by the next process", "[core]") {
  const OpenDevice device;
  const TemporaryDirectory directory;
  const std::string nested = directory.file("a/b/cache");
  CHECK(afterRestart(device, nested, 102) == kBuilt);
  CHECK(afterRestart(device, nested, 102) == kFromDisk);
  CHECK(stepOf([&] { build(device, nested, storing(102)); }) == kFromMemory);
  CHECK(afterRestart(device, nested, 103) == kBuilt);
}

TEST_CASE("binaries that cost a compilation are taken only where the next process finds them", "[core]") {
  const OpenDevice device;
  const TemporaryDirectory directory;
  for (int i = 0; i < 2; ++i)
    CHECK(stepOf([&] { CHECK(storedBy(device, build(device, "", storing(112), true)) == 112); }) == kBuilt);
  CHECK(stepOf([&] { build(device, directory.path(), storing(112), true); }) == kBuilt);
  CHECK(stepOf([&] { build(device, "", storing(112), true); }) == kFromMemory);
  CHECK(afterRestart(device, directory.path(), 112) == kFromDisk);
}

TEST_CASE("other options and other devices never share a program", "[core]") {
  const OpenDevice device;
  const std::string source = "__kernel void store(__global int* out) { out[0] = VALUE; }\n";
  DeviceTraits traits = queryDeviceTraits(device.device, Mapping::Automatic);
  const ProgramCache cache("");
  const auto buildWith = [&](const std::string& options) {
    return cache.build(device.context, device.device, traits, "store", source, options);
  };
  CHECK(storedBy(device, buildWith("-D VALUE=104")) == 104);
  CHECK(storedBy(device, buildWith("-D VALUE=105")) == 105);
  traits.identity += " with another driver";
  CHECK(stepOf([&] { buildWith("-D VALUE=104"); }) == kBuilt);
}

TEST_CASE("without a directory nothing is written", "[core]") {
  const OpenDevice device;
  const TemporaryDirectory directory;
  const fs::path before = fs::current_path();
  fs::current_path(directory.path());
  CHECK(afterRestart(device, "", 106) == kBuilt);
  fs::current_path(before);
  CHECK(directory.entryCount() == 0);
}

TEST_CASE("a damaged entry is rebuilt and replaced", "[core]") {
  const OpenDevice device;
  const TemporaryDirectory directory, otherDirectory;
  afterRestart(device, otherDirectory.path(), 108);
  const Bytes otherEntry = readFile(onlyFile(otherDirectory.path()));
  afterRestart(device, directory.path(), 107);
  const fs::path path = onlyFile(directory.path());
  const Bytes whole = readFile(path);

  std::vector<std::pair<std::string, Bytes>> damaged = {{"empty", {}}, {"another program's", otherEntry}};
  for (const std::size_t length : {std::size_t{1}, whole.size() / 2, whole.size() - 1})
    damaged.emplace_back("cut to " + std::to_string(length),
                         Bytes(whole.begin(), whole.begin() + std::ptrdiff_t(length)));
  // In the magic, the two sizes, the checksum, the key, the binary and the last byte.
  for (const std::size_t place : {std::size_t{3}, std::size_t{22}, std::size_t{30}, std::size_t{38},
                                  std::size_t{60}, whole.size() / 2, whole.size() - 1}) {
    Bytes flipped = whole;
    flipped[place] = static_cast<char>(flipped[place] ^ 0x10);
    damaged.emplace_back("flipped at " + std::to_string(place), flipped);
  }
  Bytes longer = whole;
  longer.push_back('x');
  damaged.emplace_back("too long", longer);

  for (const auto& [what, bytes] : damaged) {
    INFO(what);
    writeFile(path, bytes);
    CHECK(afterRestart(device, directory.path(), 107) == kBuilt);
    CHECK(afterRestart(device, directory.path(), 107) == kFromDisk);
  }
}

TEST_CASE("an intact entry that the driver refuses is rebuilt and replaced", "[core]") {
  const OpenDevice device;
  const TemporaryDirectory directory;
  afterRestart(device, directory.path(), 109);
  const fs::path path = onlyFile(directory.path());
  Bytes entry = readFile(path);
  // Header: magic, then sizes of key and binary and the FNV-1a checksum of the binary, 64 bits each.
  const std::string garbage = "not a program";
  const std::size_t sizes = std::string(entry.begin(), entry.end()).find('\n') + 1;
  std::uint64_t keySize = 0, binarySize = garbage.size(), checksum = 0xcbf29ce484222325ull;
  for (const char c : garbage) checksum = (checksum ^ static_cast<unsigned char>(c)) * 0x100000001b3ull;
  std::memcpy(&keySize, &entry[sizes], sizeof(keySize));
  std::memcpy(&entry[sizes + 8], &binarySize, sizeof(binarySize));
  std::memcpy(&entry[sizes + 16], &checksum, sizeof(checksum));
  entry.resize(sizes + 24 + keySize);
  entry.insert(entry.end(), garbage.begin(), garbage.end());
  writeFile(path, entry);
  CHECK(afterRestart(device, directory.path(), 109) == kBuilt);
  CHECK(afterRestart(device, directory.path(), 109) == kFromDisk);
}

TEST_CASE("a directory that cannot be written is ignored", "[core]") {
  const OpenDevice device;
  const TemporaryDirectory directory;
  const std::string file = directory.file("file");
  writeFile(file, {'x'});
  CHECK(afterRestart(device, file + "/cache", 110) == kBuilt);
  CHECK(afterRestart(device, "/proc/no-such-directory/cache", 110) == kBuilt);
  CHECK(readFile(file) == Bytes{'x'});
}

TEST_CASE("something else in the place of an entry is ignored", "[core]") {
  const OpenDevice device;
  const TemporaryDirectory directory;
  afterRestart(device, directory.path(), 111);
  const fs::path path = onlyFile(directory.path());
  fs::remove(path);
  fs::create_directory(path);
  CHECK(afterRestart(device, directory.path(), 111) == kBuilt);
  CHECK(onlyFile(directory.path()) == path);
}

TEST_CASE("threads may build the same programs at once", "[core]") {
  constexpr int kThreads = 4, kPrograms = 3, kFirst = 120;
  const TemporaryDirectory directory;
  ProgramCache::clearMemory();
  std::array<std::array<int, kPrograms>, kThreads> stored{};
  std::vector<std::thread> threads;
  const Step step = stepOf([&] {
    for (int t = 0; t < kThreads; ++t) {
      threads.emplace_back([&stored, &directory, t] {
        const OpenDevice device;
        for (int i = 0; i < kPrograms; ++i)
          stored[std::size_t(t)][std::size_t(i)] =
              storedBy(device, build(device, directory.path(), storing(kFirst + i)));
      });
    }
    for (std::thread& thread : threads) thread.join();
  });
  for (const auto& results : stored)
    for (int i = 0; i < kPrograms; ++i) CHECK(results[std::size_t(i)] == kFirst + i);
  CHECK(step.built + step.fromMemory + step.fromDisk == kThreads * kPrograms);
  CHECK(step.built >= kPrograms);
  CHECK(directory.entryCount() == kPrograms);  // no temporary file left
  const OpenDevice device;
  for (int i = 0; i < kPrograms; ++i) CHECK(afterRestart(device, directory.path(), kFirst + i) == kFromDisk);
}

TEST_CASE("a build error carries the log with file and line of the kernel source", "[core]") {
  const OpenDevice device;
  const TemporaryDirectory directory;
  try {
    ProgramCache(directory.path())
        .build(device.context, device.device, queryDeviceTraits(device.device, Mapping::Automatic),
               "remodulate", kernelSources().at("remodulate"), "-D QUELL_LANES=3");
    FAIL("no error");
  } catch (const Error& error) {
    const int line = lineOf("common/lanes.h", "#error");
    CHECK(error.code() == ErrorCode::BuildFailed);
    CHECK(error.stage() == "remodulate");
    CHECK(error.buffer().find("-D QUELL_LANES=3") != std::string::npos);
    INFO(error.got());
    CHECK(error.got().find("CL_BUILD_PROGRAM_FAILURE") != std::string::npos);
    CHECK(error.got().find("common/lanes.h:" + std::to_string(line)) != std::string::npos);
    CHECK(error.got().find("QUELL_LANES must be 1, 4, 8 or 16") != std::string::npos);
  }
  CHECK(directory.entryCount() == 0);
}

TEST_CASE("the default directory follows the environment", "[core]") {
  const char* const names[] = {"XDG_CACHE_HOME", "HOME"};
  std::vector<std::optional<std::string>> saved;
  for (const char* name : names) {
    const char* value = std::getenv(name);
    saved.push_back(value != nullptr ? std::optional<std::string>(value) : std::nullopt);
  }
  setenv("XDG_CACHE_HOME", "/x", 1);
  setenv("HOME", "/h", 1);
  CHECK(defaultCacheDirectory() == "/x/quell");
  setenv("XDG_CACHE_HOME", "", 1);
  CHECK(defaultCacheDirectory() == "/h/.cache/quell");
  unsetenv("XDG_CACHE_HOME");
  CHECK(defaultCacheDirectory() == "/h/.cache/quell");
  unsetenv("HOME");
  CHECK(defaultCacheDirectory().empty());
  for (std::size_t i = 0; i < saved.size(); ++i)
    if (saved[i]) setenv(names[i], saved[i]->c_str(), 1);
}

}  // namespace quell::tests
