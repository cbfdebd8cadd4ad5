// data/camera.schema.json and the reader of camera.json speak of the same entries.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "host/io/atomic_file.hpp"
#include "host/io/camera_file.hpp"
#include "host/io/camera_keys.hpp"
#include "tests/support/error_matcher.hpp"
#include "tests/support/temporary_directory.hpp"

using namespace quell::io;
using namespace quell::tests;
using nlohmann::json;

namespace {

constexpr double kAspect = 1.5;

std::set<std::string> keysOf(const json& object) {
  std::set<std::string> keys;
  for (const auto& [key, value] : object.items()) keys.insert(key);
  return keys;
}

class Reader {
 public:
  CameraFile read(const json& document) const {
    writeTextFile(m_path, document.dump());
    return readCameraFile(m_path, kAspect);
  }
  // The reader refuses each entry by its name if it is of a type that none may have.
  void checkThatReads(const json& document, const json::json_pointer& at, const std::string& within,
                      std::set<std::string>& read) const {
    for (const std::string& key : keysOf(document.at(at))) {
      INFO(within << key);
      json broken = document;
      broken[at][key] = json::object();
      CHECK_THROWS_MATCHES(this->read(broken), quell::Error,
                           failsWith(quell::ErrorCode::FileError, {within + key}));
      read.insert(key);
    }
  }

 private:
  TemporaryDirectory m_directory;
  std::string m_path = m_directory.file("camera.json");
};

}  // namespace

TEST_CASE("the schema of camera.json and its reader know the same entries", "[camera file]") {
  const json schema = json::parse(readFile(std::string(QUELL_DATA_DIR) + "/camera.schema.json"));
  const Reader reader;
  std::set<std::string> ofFile, ofFrame;
  for (const json& example : schema.at("examples")) {
    INFO(example.dump());
    const CameraFile file = reader.read(example);
    CHECK(file.cameras.size() == example.at("frames").size());
    // The last frame of an example has what its first has, and more; entries beside the frames hold for the first.
    const json::json_pointer frames("/frames");
    json first = example, last = example;
    first[frames] = {example[frames].front()};
    last[frames] = {example[frames].back()};
    reader.checkThatReads(first, json::json_pointer(), "", ofFile);
    reader.checkThatReads(last, json::json_pointer("/frames/0"), "frames[0].", ofFrame);
  }
  CHECK(ofFile == keysOf(schema.at("properties")));
  CHECK(ofFrame == keysOf(schema.at("$defs").at("frame").at("properties")));
  std::set<std::string> all(std::begin(kCameraKeyNames), std::end(kCameraKeyNames));
  ofFile.insert(ofFrame.begin(), ofFrame.end());
  CHECK(ofFile == all);
}
