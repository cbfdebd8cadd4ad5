#include "host/core/program_cache.hpp"

#include <cstdlib>
#include <iterator>
#include <map>
#include <mutex>
#include <optional>
#include <quell/error.hpp>
#include <utility>

#include "host/core/cl_error.hpp"

namespace quell {
namespace {

using Binary = DiskCache::Bytes;

// Binaries, and programs that somebody else holds: OpenCL objects of its own would outlive their contexts.
struct Memory {
  std::mutex mutex;
  std::map<std::string, Binary> binaries;
  std::map<std::pair<cl_context, std::string>, std::weak_ptr<const cl::Program>> programs;
  ProgramCacheCounters counters;
  std::string sourceComment;
};

Memory& memory() {
  static Memory* const instance =
      new Memory;  // never destroyed: threads may still build while the process ends
  return *instance;
}

/// What is handed to the compiler beside a stage's options: some print the number of warnings to the terminal of the host.
std::string quiet(const std::string& options) { return options + " -w"; }

std::optional<cl::Program> fromBinary(const cl::Context& context, const cl::Device& device,
                                      const Binary& binary, const std::string& options) {
  try {
    cl::Program program(context, {device}, cl::Program::Binaries{binary});
    program.build({device}, quiet(options).c_str());
    return program;
  } catch (const cl::Error&) {
    return std::nullopt;  // the driver no longer takes it
  }
}

cl::Program fromSource(const cl::Context& context, const cl::Device& device, const std::string& stage,
                       const std::string& source, const std::string& options) {
  cl::Program program(context, source);
  try {
    program.build({device}, quiet(options).c_str());
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

std::string commented(const std::string& source) {
  Memory& shared = memory();
  const std::lock_guard<std::mutex> lock(shared.mutex);
  return shared.sourceComment.empty() ? source : source + "\n// " + shared.sourceComment + "\n";
}

std::string keyOf(const DeviceTraits& traits, const std::string& source, const std::string& options) {
  return traits.identity + "\n" + options + "\n" + source;
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
                                const std::string& plainSource, const std::string& options) const {
  const std::string source = commented(plainSource);
  const std::string key = keyOf(traits, source, options);
  if (const auto binary = find(key)) {
    if (auto program = fromBinary(context, device, *binary, options)) {
      remember(key, *binary, &ProgramCacheCounters::fromMemory);
      return *program;
    }
  }
  if (const auto binary = m_disk.read(key)) {
    if (auto program = fromBinary(context, device, *binary, options)) {
      remember(key, *binary, &ProgramCacheCounters::fromDisk);
      return *program;
    }
  }
  const cl::Program program = fromSource(context, device, stage, source, options);
  // Where nothing is left for the next process, a binary that costs a compilation is not worth it.
  const bool keep = (m_disk.enabled() && m_costlyBinaries) || !traits.compilesForBinaries;
  const Binary binary = keep ? binaryOf(program, device) : Binary{};
  remember(key, binary, &ProgramCacheCounters::built);
  m_disk.write(key, binary);
  return program;
}

SharedProgram ProgramCache::share(const cl::Context& context, const cl::Device& device,
                                  const DeviceTraits& traits, const std::string& stage,
                                  const std::string& source, const std::string& options) const {
  Memory& shared = memory();
  const auto key = std::make_pair(context(), keyOf(traits, commented(source), options));
  {
    const std::lock_guard<std::mutex> lock(shared.mutex);
    const auto found = shared.programs.find(key);
    if (found != shared.programs.end())
      if (SharedProgram program = found->second.lock()) return program;
  }
  auto program = std::make_shared<const cl::Program>(build(context, device, traits, stage, source, options));
  const std::lock_guard<std::mutex> lock(shared.mutex);
  for (auto entry = shared.programs.begin(); entry != shared.programs.end();)
    entry = entry->second.expired() ? shared.programs.erase(entry) : std::next(entry);
  shared.programs[key] = program;
  return program;
}

bool ProgramCache::has(const DeviceTraits& traits, const std::string& source,
                       const std::string& options) const {
  const std::string key = keyOf(traits, commented(source), options);
  return find(key).has_value() || m_disk.read(key).has_value();
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

void ProgramCache::setSourceComment(const std::string& text) {
  Memory& shared = memory();
  const std::lock_guard<std::mutex> lock(shared.mutex);
  shared.sourceComment = text;
}

std::string defaultCacheDirectory() {
  if (const char* cache = std::getenv("XDG_CACHE_HOME"); cache != nullptr && *cache != '\0')
    return std::string(cache) + "/quell";
  if (const char* home = std::getenv("HOME"); home != nullptr && *home != '\0')
    return std::string(home) + "/.cache/quell";
  return "";
}

}  // namespace quell
