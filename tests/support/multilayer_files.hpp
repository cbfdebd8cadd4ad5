// Multilayer OpenEXR files as Blender writes them, of the built-in sequence.
#pragma once

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfOutputFile.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "host/analytic/sequence.hpp"

namespace quell::tests::multilayer {

using io::FrameData;
using io::Image;

inline constexpr int kWidth = 61, kHeight = 40;

// Pass name to its image; the channels follow from the name.
using Passes = std::map<std::string, Image>;

inline std::vector<std::string> channelNames(const std::string& pass, int channels) {
  if (pass == "Depth") return {"Z"};
  if (pass == "Combined" && channels == 4) return {"R", "G", "B", "A"};
  if (channels == 3 && pass != "Normal" && pass != "Position") return {"R", "G", "B"};
  const std::vector<std::string> names = {"X", "Y", "Z", "W"};
  return {names.begin(), names.begin() + channels};
}

inline void addPasses(const std::string& layer, const Passes& passes, Imf::Header& header,
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

inline void writeMultilayer(const std::string& path, const Passes& passes,
                            const std::string& layer = "View Layer") {
  const Image& any = passes.begin()->second;
  Imf::Header header(any.width, any.height);
  Imf::FrameBuffer buffer;
  addPasses(layer, passes, header, buffer);
  Imf::OutputFile file(path.c_str(), header);
  file.setFrameBuffer(buffer);
  file.writePixels(any.height);
}

inline double clipRow(const Matrix4& m, std::size_t row, const Image& position, int x, int y) {
  double sum = m[4 * row + 3];
  for (std::size_t axis = 0; axis < 3; ++axis) sum += m[4 * row + axis] * position.at(x, y, int(axis));
  return sum;
}

inline bool isSky(const FrameData& frame, int x, int y) {
  return frame.normalWorld.at(x, y, 0) == 0.0f && frame.normalWorld.at(x, y, 1) == 0.0f &&
         frame.normalWorld.at(x, y, 2) == 0.0f;
}

inline Image depthOf(const FrameData& frame) {
  const Matrix4& m = frame.camera.worldToClip;
  const double unit = std::sqrt(m[12] * m[12] + m[13] * m[13] + m[14] * m[14]);
  Image depth(kWidth, kHeight, 1, 1e10f);
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x)
      if (!isSky(frame, x, y)) depth.at(x, y, 0) = float(clipRow(m, 3, frame.positionWorld, x, y) / unit);
  return depth;
}

inline std::unique_ptr<io::FrameSequence> builtIn() {
  io::AnalyticOptions options;
  options.width = kWidth;
  options.height = kHeight;
  return io::makeAnalyticSequence(options);
}

inline Passes passesOf(const FrameData& frame) {
  return {{"Combined", frame.radiance},      {"Normal", frame.normalWorld}, {"Position", frame.positionWorld},
          {"Depth", depthOf(frame)},         {"DiffCol", frame.albedo},     {"Emit", frame.emission},
          {"Env", Image(kWidth, kHeight, 3)}};
}

// Largest distance of projected positions from where they should be, pixels.
inline double projectionError(const Matrix4& matrix, const Matrix4& expected, const FrameData& frame) {
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

}  // namespace quell::tests::multilayer
