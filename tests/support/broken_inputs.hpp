// Small frames in all layouts, to break something in, and what the tool says of it.
#pragma once

#include <catch2/catch.hpp>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "host/io/atomic_file.hpp"
#include "host/io/exr_image.hpp"
#include "tests/support/multilayer_files.hpp"
#include "tests/support/temporary_directory.hpp"
#include "tests/support/test_images.hpp"
#include "tests/support/tool.hpp"

namespace quell::tests::broken {

namespace fs = std::filesystem;

inline constexpr int kWidth = 6, kHeight = 4;
inline constexpr char kMatrix[] = "[[1,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,1,5]]";

inline std::string cameraText(const std::string& entry) {
  return "{\"frames\": [{\"frame\": 1, " + entry + "}, {\"frame\": 2, \"view_projection\": " + kMatrix +
         "}]}";
}

// A folder to break something in. Frames 1 and 2 in all layouts.
struct Input {
  std::string folder;

  std::string file(const std::string& name) const { return folder + "/" + name; }
  void write(const std::string& name, const std::string& bytes) const {
    io::writeTextFile(file(name), bytes);
  }
  void image(const std::string& name, const std::vector<std::string>& channels, int width = kWidth) const {
    io::writeExr(file(name), noiseImage(width, kHeight, int(channels.size()), 1), channels,
                 io::ExrType::Float);
  }
  void remove(const std::string& name) const { fs::remove_all(file(name)); }
  void cut(const std::string& name, double share) const {
    const std::string bytes = io::readFile(file(name));
    write(name, bytes.substr(0, std::size_t(share * double(bytes.size()))));
  }
  void asFolder(const std::string& name) const {
    remove(name);
    fs::create_directory(file(name));
  }
  void camera(const std::string& entry) const { write("camera.json", cameraText(entry)); }
  void multilayer(const std::string& name, multilayer::Passes passes,
                  const std::string& layer = "View Layer") const {
    multilayer::writeMultilayer(file(name), passes, layer);
  }
};

inline void writeSeparate(const Input& input) {
  for (const char* frame : {"_0001.exr", "_0002.exr"})
    for (const char* buffer : {"color", "shading_normal", "world_position", "albedo"})
      input.image(std::string(buffer) + frame, {"R", "G", "B"});
  input.camera(std::string("\"view_projection\": ") + kMatrix);
}

inline multilayer::Passes somePasses() {
  return {{"Combined", noiseImage(kWidth, kHeight, 4, 1)},
          {"Normal", noiseImage(kWidth, kHeight, 3, 2)},
          {"Position", noiseImage(kWidth, kHeight, 3, 3)},
          {"Depth", noiseImage(kWidth, kHeight, 1, 4)}};
}

inline multilayer::Passes passesWithout(const std::string& pass) {
  multilayer::Passes passes = somePasses();
  passes.erase(pass);
  return passes;
}

inline void writeMultilayer(const Input& input) {
  for (const char* name : {"0001.exr", "0002.exr"}) input.multilayer(name, somePasses());
}

inline void writeBmfr(const Input& input) {
  for (const char* frame : {"0.exr", "1.exr"})
    for (const char* buffer : {"color", "shading_normal", "world_position", "albedo"})
      input.image(std::string(buffer) + frame, {"R", "G", "B"});
  input.write("camera_matrices.h",
              "const float camera_matrices[2][4][4] = {1,0,0,0, 0,1,0,0, 0,0,1,1, 0,0,0,5, 1,0,0,0, 0,1,0,0, "
              "0,0,1,1, 0,0,0,5};\nconst float pixel_offsets[2][2] = {0.5, 0.5, 0.5, 0.5};\n");
}

struct Broken {
  const char* what;
  std::function<void(const Input&)> damage;
  std::vector<std::string> words;      // of the message
  std::vector<std::string> more = {};  // arguments
  const char* path = "";               // of the input, in the folder
};

using Rows = std::vector<Broken>;

inline void check(const std::string& layout, const std::function<void(const Input&)>& prepare,
                  const Rows& rows) {
  for (const Broken& row : rows) {
    INFO(layout << ": " << row.what);
    const TemporaryDirectory directory;
    const Input input{directory.file("in")};
    fs::create_directory(input.folder);
    prepare(input);
    row.damage(input);
    const std::string out = directory.file("out");
    std::vector<std::string> arguments = {"denoise", "--output", out, "--input",
                                          *row.path == '\0' ? input.folder : input.file(row.path)};
    arguments.insert(arguments.end(), row.more.begin(), row.more.end());
    const std::string message = errorStreamOf(arguments, 1, directory.file("stderr"));
    CHECK_THAT(message,
               Catch::StartsWith("quell: ") && Catch::Contains("expected") && Catch::Contains("got"));
    for (const std::string& word : row.words) CHECK_THAT(message, Catch::Contains(word));
    CHECK((!fs::exists(out) || fs::is_empty(out)));
  }
}

}  // namespace quell::tests::broken
