#include "host/io/multilayer_sequence.hpp"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfOutputFile.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <map>
#include <memory>

#include "host/analytic/sequence.hpp"
#include "host/io/atomic_file.hpp"
#include "host/io/multilayer_camera.hpp"
#include "tests/support/error_matcher.hpp"
#include "tests/support/temporary_directory.hpp"
#include "tests/support/test_images.hpp"

using namespace quell::io;
using quell::Error;
using quell::ErrorCode;
using quell::Matrix4;
using quell::tests::failsWith;
using quell::tests::noiseImage;
using quell::tests::samePixels;
using quell::tests::TemporaryDirectory;

namespace {

constexpr int kWidth = 61, kHeight = 40;

// Pass name to its image; the channels follow from the name.
using Passes = std::map<std::string, Image>;

std::vector<std::string> channelNames(const std::string& pass, int channels) {
  if (pass == "Depth") return {"Z"};
  if (channels == 3 && pass != "Normal" && pass != "Position") return {"R", "G", "B"};
  const std::vector<std::string> names = {"X", "Y", "Z", "W"};
  return {names.begin(), names.begin() + channels};
}

void addPasses(const std::string& layer, const Passes& passes, Imf::Header& header,
               Imf::FrameBuffer& buffer) {
  for (const auto& [pass, image] : passes) {
    const std::vector<std::string> names = channelNames(pass, image.channels);
    const std::size_t stride = names.size() * sizeof(float);
    for (std::size_t c = 0; c < names.size(); ++c) {
      const std::string name = layer + "." + pass + "." + names[c];
      header.channels().insert(name, Imf::Channel(Imf::FLOAT));
      char* pixels = reinterpret_cast<char*>(const_cast<float*>(image.pixels.data() + c));
      buffer.insert(name, Imf::Slice(Imf::FLOAT, pixels, stride, stride * std::size_t(image.width)));
    }
  }
}

void writeMultilayer(const std::string& path, const Passes& passes, const std::string& layer = "View Layer") {
  const Image& any = passes.begin()->second;
  Imf::Header header(any.width, any.height);
  Imf::FrameBuffer buffer;
  addPasses(layer, passes, header, buffer);
  Imf::OutputFile file(path.c_str(), header);
  file.setFrameBuffer(buffer);
  file.writePixels(any.height);
}

double clipRow(const Matrix4& m, std::size_t row, const Image& position, int x, int y) {
  double sum = m[4 * row + 3];
  for (std::size_t axis = 0; axis < 3; ++axis) sum += m[4 * row + axis] * position.at(x, y, int(axis));
  return sum;
}

bool isSky(const FrameData& frame, int x, int y) {
  return frame.normalWorld.at(x, y, 0) == 0.0f && frame.normalWorld.at(x, y, 1) == 0.0f &&
         frame.normalWorld.at(x, y, 2) == 0.0f;
}

Image depthOf(const FrameData& frame) {
  const Matrix4& m = frame.camera.worldToClip;
  const double unit = std::sqrt(m[12] * m[12] + m[13] * m[13] + m[14] * m[14]);
  Image depth(kWidth, kHeight, 1, 1e10f);
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x)
      if (!isSky(frame, x, y)) depth.at(x, y, 0) = float(clipRow(m, 3, frame.positionWorld, x, y) / unit);
  return depth;
}

std::unique_ptr<FrameSequence> builtIn() {
  AnalyticOptions options;
  options.width = kWidth;
  options.height = kHeight;
  return makeAnalyticSequence(options);
}

Passes passesOf(const FrameData& frame) {
  return {{"Combined", frame.radiance},      {"Normal", frame.normalWorld}, {"Position", frame.positionWorld},
          {"Depth", depthOf(frame)},         {"DiffCol", frame.albedo},     {"Emit", frame.emission},
          {"Env", Image(kWidth, kHeight, 3)}};
}

// Largest distance of projected positions from where they should be, pixels.
double projectionError(const Matrix4& matrix, const Matrix4& expected, const FrameData& frame) {
  double worst = 0.0;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      if (isSky(frame, x, y)) continue;
      const auto pixel = [&](const Matrix4& m, std::size_t row, int size) {
        return 0.5 * size * clipRow(m, row, frame.positionWorld, x, y) /
               clipRow(m, 3, frame.positionWorld, x, y);
      };
      worst = std::max({worst, std::abs(pixel(matrix, 0, kWidth) - pixel(expected, 0, kWidth)),
                        std::abs(pixel(matrix, 1, kHeight) - pixel(expected, 1, kHeight))});
    }
  }
  return worst;
}

std::string matrixText(const Matrix4& m) {
  std::string text = "[";
  for (std::size_t row = 0; row < 4; ++row) {
    text += row > 0 ? ",[" : "[";
    for (std::size_t column = 0; column < 4; ++column)
      text += (column > 0 ? "," : "") + std::to_string(m[4 * row + column]);
    text += "]";
  }
  return text + "]";
}

}  // namespace

TEST_CASE("a multilayer file is read as a sequence of one frame, with the camera that it shows") {
  const TemporaryDirectory directory;
  const FrameData original = builtIn()->read(3);
  Passes passes = passesOf(original);
  passes["GlossCol"] = noiseImage(kWidth, kHeight, 3, 1);
  passes["IndexOB"] = Image(kWidth, kHeight, 1, 5.0f);
  passes["Vector"] = noiseImage(kWidth, kHeight, 4, 2);
  passes["Env"] = Image(kWidth, kHeight, 3, 0.25f);
  writeMultilayer(directory.file("shot_0012.exr"), passes);
  const auto sequence = openSequence(directory.file("shot_0012.exr"));
  REQUIRE(sequence->frames() == std::vector<int>{12});
  REQUIRE(sequence->width() == kWidth);
  REQUIRE(sequence->height() == kHeight);
  REQUIRE_FALSE(sequence->hasReference(12, ReferenceKind::Centre));
  const FrameData frame = sequence->read(12);
  REQUIRE(frame.number == 12);
  REQUIRE_FALSE(frame.demodulated);
  REQUIRE(samePixels(frame.radiance, original.radiance));
  REQUIRE(samePixels(frame.normalWorld, original.normalWorld));
  REQUIRE(samePixels(frame.positionWorld, original.positionWorld));
  REQUIRE(samePixels(frame.albedo, original.albedo));
  REQUIRE(samePixels(frame.glossColor, passes["GlossCol"]));
  REQUIRE(samePixels(frame.objectId, passes["IndexOB"]));
  REQUIRE(frame.emission.at(7, 9, 1) == original.emission.at(7, 9, 1) + 0.25f);
  REQUIRE(projectionError(frame.camera.worldToClip, original.camera.worldToClip, original) < 1e-3);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      if (isSky(original, x, y)) {
        REQUIRE(std::isnan(frame.motion.at(x, y, 1)));
      } else {
        REQUIRE(frame.motion.at(x, y, 0) == passes["Vector"].at(x, y, 0));
        REQUIRE(frame.motion.at(x, y, 1) == -passes["Vector"].at(x, y, 1));
      }
    }
  }
}

TEST_CASE("a directory of multilayer files has the camera of the frame before, too") {
  const TemporaryDirectory directory;
  const auto original = builtIn();
  for (const int number : {1, 2}) {
    writeMultilayer(directory.file("000" + std::to_string(number) + ".exr"),
                    passesOf(original->read(number)));
  }
  const auto sequence = openSequence(directory.path());
  REQUIRE(sequence->frames() == std::vector<int>{1, 2});
  const FrameData expected = original->read(2), frame = sequence->read(2);
  REQUIRE(projectionError(frame.camera.worldToClip, expected.camera.worldToClip, expected) < 1e-3);
  REQUIRE(projectionError(frame.camera.worldToClipPrev, expected.camera.worldToClipPrev, expected) < 1e-3);
  REQUIRE_THROWS_MATCHES(sequence->read(3), Error, failsWith(ErrorCode::InvalidArgument, {"1 to 2"}));
  writeMultilayer(directory.file("0004.exr"), passesOf(original->read(4)));
  REQUIRE_THROWS_MATCHES(openSequence(directory.path()), Error,
                         failsWith(ErrorCode::FileError, {"0003.exr", "without gaps"}));
}

TEST_CASE("diffuse and glossy passes are two signals") {
  const TemporaryDirectory directory;
  Passes passes = passesOf(builtIn()->read(0));
  for (const char* pass : {"DiffDir", "DiffInd", "GlossDir", "GlossInd", "GlossCol"})
    passes[pass] = noiseImage(kWidth, kHeight, 3, unsigned(passes.size()));
  writeMultilayer(directory.file("0.exr"), passes);
  const FrameData frame = openSequence(directory.path(), 2)->read(0);
  REQUIRE(frame.demodulated);
  REQUIRE(samePixels(frame.combined, passes["Combined"]));
  REQUIRE(frame.radiance.at(3, 5, 2) == passes["DiffDir"].at(3, 5, 2) + passes["DiffInd"].at(3, 5, 2));
  REQUIRE(frame.glossyRadiance.at(3, 5, 2) ==
          passes["GlossDir"].at(3, 5, 2) + passes["GlossInd"].at(3, 5, 2));
  passes.erase("GlossInd");
  writeMultilayer(directory.file("0.exr"), passes);
  REQUIRE_NOTHROW(openSequence(directory.path()));
  REQUIRE_THROWS_MATCHES(openSequence(directory.path(), 2), Error,
                         failsWith(ErrorCode::FileError, {"View Layer.GlossInd"}));
}

TEST_CASE("depth and a camera.json stand in for positions") {
  const TemporaryDirectory directory;
  const FrameData original = builtIn()->read(3);
  Passes passes = passesOf(original);
  passes.erase("Position");
  writeMultilayer(directory.file("0003.exr"), passes);
  REQUIRE_THROWS_MATCHES(openSequence(directory.path()), Error,
                         failsWith(ErrorCode::FileError, {"View Layer.Position", "camera.json"}));
  const std::string matrix = matrixText(original.camera.worldToClip);
  writeTextFile(directory.file("camera.json"), "{\"frames\": [{\"frame\": 3, \"view_projection\": " + matrix +
                                                   ", \"previous_view_projection\": " + matrix + "}]}");
  const FrameData frame = openSequence(directory.path())->read(3);
  double worst = 0.0;
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x)
      for (int axis = 0; axis < 3 && !isSky(original, x, y); ++axis)
        worst = std::max(worst, std::abs(double(frame.positionWorld.at(x, y, axis)) -
                                         original.positionWorld.at(x, y, axis)));
  REQUIRE(worst < 1e-3);
}

TEST_CASE("passes and layers that are missing are named") {
  const TemporaryDirectory directory;
  const Passes all = passesOf(builtIn()->read(0));
  const std::string path = directory.file("0007.exr");
  const auto openWithout = [&](const char* pass) {
    Passes passes = all;
    passes.erase(pass);
    writeMultilayer(path, passes);
    return openSequence(path);
  };
  REQUIRE_THROWS_MATCHES(openWithout("Normal"), Error,
                         failsWith(ErrorCode::FileError, {"0007.exr", "View Layer.Normal"}));
  REQUIRE_THROWS_MATCHES(openWithout("Depth"), Error,
                         failsWith(ErrorCode::FileError, {"View Layer.Depth", "camera.json"}));
  REQUIRE_THROWS_MATCHES(openWithout("Combined"), Error, failsWith(ErrorCode::FileError, {"multilayer"}));
  for (const char* pass : {"DiffCol", "Emit", "Env"}) REQUIRE_NOTHROW(openWithout(pass)->read(7));

  Imf::Header header(kWidth, kHeight);
  Imf::FrameBuffer buffer;
  addPasses("Front", all, header, buffer);
  addPasses("Back", all, header, buffer);
  {
    Imf::OutputFile file(path.c_str(), header);
    file.setFrameBuffer(buffer);
    file.writePixels(kHeight);
  }
  REQUIRE_THROWS_MATCHES(openSequence(path), Error,
                         failsWith(ErrorCode::FileError, {"one view layer", "Back, Front"}));
}

TEST_CASE("no camera follows from a plane, from nothing, or from depth that does not fit") {
  const FrameData frame = builtIn()->read(3);
  const Image depth = depthOf(frame);
  REQUIRE(findCamera(frame.positionWorld, depth).has_value());
  REQUIRE_FALSE(findCamera(frame.positionWorld, Image(kWidth, kHeight, 1, 1e10f)).has_value());
  REQUIRE_FALSE(findCamera(frame.positionWorld, noiseImage(kWidth, kHeight, 1, 3)).has_value());
  Image plane(kWidth, kHeight, 3);
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      plane.at(x, y, 0) = float(x);
      plane.at(x, y, 1) = float(y);
    }
  REQUIRE_FALSE(findCamera(plane, Image(kWidth, kHeight, 1, 5.0f)).has_value());

  const TemporaryDirectory directory;
  Passes passes = passesOf(frame);
  passes["Position"] = plane;
  passes["Depth"] = Image(kWidth, kHeight, 1, 5.0f);
  writeMultilayer(directory.file("0.exr"), passes);
  REQUIRE_THROWS_MATCHES(openSequence(directory.path())->read(0), Error,
                         failsWith(ErrorCode::FileError, {"camera.json", "one plane"}));
}
