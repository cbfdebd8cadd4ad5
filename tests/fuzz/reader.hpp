// What the fuzzers of readers share: the input as a file, what a reader may do with it, and how it is called.
#pragma once

#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <quell/error.hpp>
#include <string>
#include <vector>

namespace quell::fuzz {

/// A reader of untrusted bytes. One of each file here, at namespace scope; its seeds are in seeds/NAME.
struct Reader {
  using Read = void (*)(const std::uint8_t* bytes, std::size_t count);

  Reader(const char* itsName, Read itsRead) : name(itsName), read(itsRead) { all().push_back(this); }

  /// Those of the program, in no order.
  static std::vector<const Reader*>& all() {
    static std::vector<const Reader*> readers;
    return readers;
  }

  const char* name;
  Read read;
};

/// Where the files of a process lie. In memory where there is such a place: what waits for a disk takes minutes.
inline const std::filesystem::path& directoryOfFiles() {
  namespace fs = std::filesystem;
  static const fs::path directory = [] {
    const fs::path memory = "/dev/shm";
    const fs::path path = (fs::is_directory(memory) ? memory : fs::temp_directory_path()) /
                          ("quell_fuzz_" + std::to_string(::getpid()));
    fs::create_directories(path);
    return path;
  }();
  return directory;
}

inline void writeFile(const std::string& path, const std::uint8_t* bytes, std::size_t count) {
  std::ofstream(path, std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes), static_cast<std::streamsize>(count));
}

/// A file of these bytes, the same path for all inputs of a process. `name` decides what some readers take it for.
inline std::string asFile(const std::uint8_t* bytes, std::size_t count, const std::string& name) {
  const std::string path = (directoryOfFiles() / name).string();
  writeFile(path, bytes, count);
  return path;
}

/// Readers refuse with Error. Anything else that leaves them is a fault and ends the fuzzer.
template <typename Read>
void attempt(Read read) {
  try {
    read();
  } catch (const Error&) {
  }
}

}  // namespace quell::fuzz
