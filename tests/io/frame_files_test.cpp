#include "host/io/frame_files.hpp"

#include <catch2/catch.hpp>
#include <filesystem>

#include "host/io/atomic_file.hpp"
#include "host/io/frame_sequence.hpp"
#include "tests/support/error_matcher.hpp"
#include "tests/support/multilayer_files.hpp"
#include "tests/support/temporary_directory.hpp"

using namespace quell::io;
using quell::Error;
using quell::ErrorCode;
using quell::tests::failsWith;
using quell::tests::TemporaryDirectory;
using namespace quell::tests::multilayer;

namespace {

struct Names {
  TemporaryDirectory directory;

  explicit Names(const std::vector<std::string>& names) {
    for (const std::string& name : names) writeTextFile(directory.file(name), "");
  }
  std::vector<std::string> patterns() const {
    std::vector<std::string> found;
    for (const FrameFiles& files : FrameDirectory(directory.path()).all())
      found.push_back(std::filesystem::path(files.pattern()).filename().string());
    return found;
  }
  std::vector<int> frames() const {
    const std::vector<FrameFiles> all = FrameDirectory(directory.path()).all();
    REQUIRE(all.size() == 1);
    for (const int frame : all.front().frames()) REQUIRE(std::filesystem::exists(all.front().path(frame)));
    return all.front().frames();
  }
  FrameFiles like(const std::string& pattern) const { return findFrameFiles(directory.file(pattern)); }
};

}  // namespace

TEST_CASE("frames are in the order of their numbers, whatever the padding", "[frame files]") {
  CHECK(Names({"9998.exr", "9999.exr", "10000.exr", "10001.exr"}).frames() ==
        std::vector<int>{9998, 9999, 10000, 10001});
  CHECK(Names({"9.exr", "10.exr", "008.exr"}).frames() == std::vector<int>{8, 9, 10});
  CHECK(Names({"shot.v01.0007.exr", "shot.v01.0008.EXR"}).frames() == std::vector<int>{7, 8});
  CHECK(Names({"\xc3\xa9t\xc3\xa9 #2_0001.exr", "notes.txt"}).frames() == std::vector<int>{1});
  CHECK(Names({"render.exr"}).frames() == std::vector<int>{0});
  // What does not fit an int belongs to the name.
  CHECK(Names({"20261128120000.exr"}).frames() == std::vector<int>{128120000});
}

TEST_CASE("a minus is a sign unless it follows a letter or digit", "[frame files]") {
  CHECK(Names({"-0002.exr", "-0001.exr", "0000.exr"}).frames() == std::vector<int>{-2, -1, 0});
  CHECK(Names({"color_-0001.exr", "color_0000.exr"}).frames() == std::vector<int>{-1, 0});
  CHECK(Names({"shot-0001.exr", "shot-0002.exr", "shot--0001.exr"}).frames() == std::vector<int>{-1, 1, 2});
  CHECK(paddedFrame(-7) == "-0007");
  CHECK(paddedFrame(12345) == "12345");
}

TEST_CASE("numbers may stand before the end of a name, by themselves", "[frame files]") {
  CHECK(Names({"0001_ALBEDO.exr", "0002_ALBEDO.EXR"}).frames() == std::vector<int>{1, 2});
  CHECK(Names({"shot.0007.N.exr", "shot.0008.N.exr"}).frames() == std::vector<int>{7, 8});
  CHECK(Names({"-0001 a.exr", "0000 a.exr"}).frames() == std::vector<int>{-1, 0});
  CHECK(Names({"9_a.exr", "10_a.exr", "11_a.exr"}).like("##_a.exr").frames() == std::vector<int>{9, 10, 11});
  CHECK(Names({"0001_a.exr", "0001_b.exr", "0001.exr"}).patterns() ==
        std::vector<std::string>{"####.exr", "####_a.exr", "####_b.exr"});
  // A number at the end goes before, and one within a word is none.
  CHECK(Names({"0001_cam_0007.exr"}).frames() == std::vector<int>{7});
  CHECK(Names({"cam2_beauty.exr"}).frames() == std::vector<int>{0});
}

TEST_CASE("sequences are what names have in common", "[frame files]") {
  CHECK(Names({"a_0001.exr", "b_0001.exr", "b_0002.exr", "take2_01.exr"}).patterns() ==
        std::vector<std::string>{"a_####.exr", "b_####.exr", "take2_##.exr"});
  REQUIRE_THROWS_MATCHES(
      Names({"1.exr", "01.exr"}).patterns(), Error,
      failsWith(ErrorCode::FileError, {"one file for frame 1", "01.exr", "1.exr as well"}));
}

TEST_CASE("patterns name one of several sequences", "[frame files]") {
  const Names names({"a_0001.exr", "a_0002.exr", "a_10000.exr", "b_0001.exr", "c-0003.left.exr"});
  for (const char* pattern : {"a_####.exr", "a_%04d.exr", "a_%d.exr", "a_*.exr", "a_#.exr"}) {
    INFO(pattern);
    CHECK(isFramePattern(names.directory.file(pattern)));
    CHECK(names.like(pattern).frames() == std::vector<int>{1, 2, 10000});
  }
  CHECK(names.like("a_000?.exr").frames() == std::vector<int>{1, 2});
  CHECK(names.like("c-####.left.exr").frames() == std::vector<int>{3});
  REQUIRE_THROWS_MATCHES(
      names.like("?_*.exr"), Error,
      failsWith(ErrorCode::FileError, {"one sequence", "2 of them", "a_####.exr", "b_####.exr", "--input"}));
  REQUIRE_THROWS_MATCHES(names.like("d_####.exr"), Error, failsWith(ErrorCode::FileError, {"d_####.exr"}));
  REQUIRE_THROWS_MATCHES(findFrameFiles("/nowhere/at/all/####.exr"), Error,
                         failsWith(ErrorCode::FileError, {"/nowhere/at/all"}));
}

TEST_CASE("files listed one by one are a sequence in the order of their numbers", "[frame files]") {
  const Names names({"a_0001.exr", "a_0002.exr", "a_10000.exr", "b_0001.exr"});
  const auto path = [&](const char* name) { return names.directory.file(name); };
  CHECK(listedFiles({path("a_10000.exr"), path("a_0002.exr")}).frames() == std::vector<int>{2, 10000});
  REQUIRE_THROWS_MATCHES(listedFiles({path("a_0001.exr"), path("b_0001.exr")}), Error,
                         failsWith(ErrorCode::FileError, {"a_####.exr", "b_####.exr"}));
  REQUIRE_THROWS_MATCHES(listedFiles({path("a_0001.exr"), path("a_0007.exr")}), Error,
                         failsWith(ErrorCode::FileError, {"a_0007.exr"}));
}

TEST_CASE("a gap is refused with what is missing, or marked as a cut", "[frame files]") {
  const TemporaryDirectory directory;
  const Passes passes = passesOf(builtIn()->read(0));
  for (const char* number : {"-0001", "0000", "0002", "0006"})
    writeMultilayer(directory.file(std::string("a_") + number + ".exr"), passes);
  REQUIRE_THROWS_MATCHES(openSequence(directory.path()), Error,
                         failsWith(ErrorCode::FileError, {"a_0001.exr", "frames -1 to 6 without gaps",
                                                          "no frames 1, 3 to 5", "--missing skip"}));
  const auto sequence = openSequence(directory.file("a_####.exr"), {1, MissingFrames::Skip});
  CHECK(sequence->frames() == std::vector<int>{-1, 0, 2, 6});
  CHECK_FALSE(sequence->read(-1).afterGap);
  CHECK_FALSE(sequence->read(0).afterGap);
  const FrameData after = sequence->read(2);
  CHECK(after.afterGap);
  CHECK(after.camera.worldToClipPrev == after.camera.worldToClip);
  REQUIRE(after.warnings.size() == 1);
  CHECK(after.warnings.front().got == "no frames 1, 3 to 5");
  SequenceOptions listed;
  listed.furtherFiles = {directory.file("a_-0001.exr")};
  CHECK(openSequence(directory.file("a_0000.exr"), listed)->frames() == std::vector<int>{-1, 0});
  writeMultilayer(directory.file("b_0002.exr"), passes);
  REQUIRE_THROWS_MATCHES(openSequence(directory.path()), Error,
                         failsWith(ErrorCode::FileError, {"a_####.exr", "b_####.exr"}));
}
