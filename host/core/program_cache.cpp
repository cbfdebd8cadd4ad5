#include "host/core/program_cache.hpp"

#include <atomic>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <mutex>
#include <optional>
#include <quell/error.hpp>
#include <random>
#include <vector>

#include "host/core/cl_error.hpp"

namespace quell {
namespace {

using Binary = std::vector<unsigned char>;

// First bytes of a disk entry; the number changes with the layout.
constexpr char kMagic[] = "quell program cache 1\n";

// FNV-1a, 64 bits (Fowler, Noll, Vo): names files and finds damage; the key itself is compared in full.
std::uint64_t hashBytes(const void* data, std::size_t size, std::uint64_t hash = 0xcbf29ce484222325ull) {
  const auto* bytes = static_cast<const unsigned char*>(data);
  for (std::size_t i = 0; i < size; ++i) hash = (hash ^ bytes[i]) * 0x100000001b3ull;
  return hash;
}

// Binaries only: OpenCL objects here would outlive their contexts.
struct Memory {
  std::mutex mutex;
  std::map<std::string, Binary> binaries;
  ProgramCacheCounters counters;
};

Memory& memory() {
  static Memory* const instance =
      new Memory;  // never destroyed: threads may still build while the process ends
  return *instance;
}

template <class Number>
void append(Binary& bytes, Number value) {
  const auto* raw = reinterpret_cast<const unsigned char*>(&value);
  bytes.insert(bytes.end(), raw, raw + sizeof(value));
}

Binary diskEntry(const std::string& key, const Binary& binary) {
  Binary entry(kMagic, kMagic + sizeof(kMagic) - 1);
  append(entry, static_cast<std::uint64_t>(key.size()));
  append(entry, static_cast<std::uint64_t>(binary.size()));
  append(entry, hashBytes(binary.data(), binary.size()));
  entry.insert(entry.end(), key.begin(), key.end());
  entry.insert(entry.end(), binary.begin(), binary.end());
  return entry;
}

std::string entryPath(const std::string& directory, const std::string& key) {
  char name[32];
  std::snprintf(name, sizeof(name), "%016llx.bin",
                static_cast<unsigned long long>(hashBytes(key.data(), key.size())));
  return (std::filesystem::path(directory) / name).string();
}

Binary readFile(const std::string& path) {
  try {
    std::ifstream file(path, std::ios::binary);
    return Binary((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  } catch (const std::ios_base::failure&) {
    return {};  // a directory, a broken disk
  }
}

// An entry is trusted only if rebuilding it from its own parts gives the same bytes and the key is ours.
std::optional<Binary> readEntry(const std::string& path, const std::string& key) {
  const Binary entry = readFile(path);
  const std::size_t header = sizeof(kMagic) - 1 + 3 * sizeof(std::uint64_t);
  if (entry.size() < header + key.size()) return std::nullopt;
  const Binary binary(entry.begin() + static_cast<std::ptrdiff_t>(header + key.size()), entry.end());
  if (binary.empty() || diskEntry(key, binary) != entry) return std::nullopt;
  return binary;
}

// Best effort: a full or read-only disk must not stop anybody from denoising.
void writeEntry(const std::string& directory, const std::string& key, const Binary& binary) {
  std::error_code ignored;
  std::filesystem::create_directories(directory, ignored);
  const std::string path = entryPath(directory, key);
  const std::string temporary = path + "." + std::to_string(std::random_device{}()) + ".tmp";
  {
    std::ofstream file(temporary, std::ios::binary);
    const Binary entry = diskEntry(key, binary);
    file.write(reinterpret_cast<const char*>(entry.data()), static_cast<std::streamsize>(entry.size()));
    file.close();
    if (!file) {
      std::filesystem::remove(temporary, ignored);
      return;
    }
  }
  std::filesystem::rename(temporary, path, ignored);
  if (ignored) std::filesystem::remove(temporary, ignored);
}

std::optional<cl::Program> fromBinary(const cl::Context& context, const cl::Device& device,
                                      const Binary& binary, const std::string& options) {
  try {
    cl::Program program(context, {device}, cl::Program::Binaries{binary});
    program.build({device}, options.c_str());
    return program;
  } catch (const cl::Error&) {
    return std::nullopt;  // the driver no longer takes it
  }
}

cl::Program fromSource(const cl::Context& context, const cl::Device& device, const std::string& stage,
                       const std::string& source, const std::string& options) {
  cl::Program program(context, source);
  try {
    program.build({device}, options.c_str());
  } catch (const cl::Error& error) {
    const std::string log = program.getBuildInfo<CL_PROGRAM_BUILD_LOG>(device);
    throw Error(ErrorCode::BuildFailed,
                {stage, "options " + options, "a kernel that the device's compiler accepts",
                 clErrorName(error.err()) + "\n" + log});
  }
  return program;
}

// The binary of `device`; a context with several devices gives one per device.
Binary binaryOf(const cl::Program& program, const cl::Device& device) {
  const auto devices = program.getInfo<CL_PROGRAM_DEVICES>();
  const auto binaries = program.getInfo<CL_PROGRAM_BINARIES>();
  for (std::size_t i = 0; i < devices.size() && i < binaries.size(); ++i)
    if (devices[i]() == device()) return binaries[i];
  return {};
}

std::optional<Binary> find(const std::string& key) {
  Memory& shared = memory();
  const std::lock_guard<std::mutex> lock(shared.mutex);
  const auto found = shared.binaries.find(key);
  return found == shared.binaries.end() ? std::nullopt : std::optional<Binary>(found->second);
}

void remember(const std::string& key, const Binary& binary, int ProgramCacheCounters::*counter) {
  Memory& shared = memory();
  const std::lock_guard<std::mutex> lock(shared.mutex);
  if (!binary.empty()) shared.binaries[key] = binary;
  ++(shared.counters.*counter);
}

}  // namespace

cl::Program ProgramCache::build(const cl::Context& context, const cl::Device& device,
                                const DeviceTraits& traits, const std::string& stage,
                                const std::string& source, const std::string& options) const {
  const std::string key = traits.identity + "\n" + options + "\n" + source;
  if (const auto binary = find(key)) {
    if (auto program = fromBinary(context, device, *binary, options)) {
      remember(key, *binary, &ProgramCacheCounters::fromMemory);
      return *program;
    }
  }
  if (!m_directory.empty()) {
    if (const auto binary = readEntry(entryPath(m_directory, key), key)) {
      if (auto program = fromBinary(context, device, *binary, options)) {
        remember(key, *binary, &ProgramCacheCounters::fromDisk);
        return *program;
      }
    }
  }
  const cl::Program program = fromSource(context, device, stage, source, options);
  const Binary binary = binaryOf(program, device);
  remember(key, binary, &ProgramCacheCounters::built);
  if (!m_directory.empty() && !binary.empty()) writeEntry(m_directory, key, binary);
  return program;
}

ProgramCacheCounters ProgramCache::counters() {
  Memory& shared = memory();
  const std::lock_guard<std::mutex> lock(shared.mutex);
  return shared.counters;
}

void ProgramCache::clearMemory() {
  Memory& shared = memory();
  const std::lock_guard<std::mutex> lock(shared.mutex);
  shared.binaries.clear();
}

std::string defaultCacheDirectory() {
  if (const char* cache = std::getenv("XDG_CACHE_HOME"); cache != nullptr && *cache != '\0')
    return std::string(cache) + "/quell";
  if (const char* home = std::getenv("HOME"); home != nullptr && *home != '\0')
    return std::string(home) + "/.cache/quell";
  return "";
}

}  // namespace quell
