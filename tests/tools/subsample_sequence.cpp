// quell_subsample_sequence INPUT OUTPUT FIRST LAST: keeps every second pixel in x and y (even column, even
// row) of the frames FIRST to LAST of a sequence in the Cycles layout (host/io/cycles_sequence.hpp).
// data/colonnade was made so.
//
// Pixels are picked, not averaged: normals stay unit length, positions stay on surfaces, noise stays that of
// one sample. The kept pixel 2i has its centre at 2i + 0.5 of the old grid, i + 0.25 of the new; all matrices
// get a shift of +0.25 new pixels in x and y, so that positions project to pixel centres again and jitter
// stays zero.
#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <quell/error.hpp>
#include <string>

#include "host/io/atomic_file.hpp"
#include "host/io/camera_keys.hpp"
#include "host/io/cycles_sequence.hpp"
#include "host/io/image_sources.hpp"
#include "host/io/sequence_files.hpp"

namespace {

using quell::Matrix4;
using quell::io::Image;
using quell::io::ImageSource;

constexpr int kStep = 2;
/// From where a kept pixel's centre falls (0.25) to where it belongs (0.5), in pixels of the new grid.
constexpr double kCentreShiftPx = 0.25;
/// Normalised device coordinates span [-1, 1].
constexpr double kNdcRange = 2.0;

Image subsample(const Image& image) {
  Image kept(image.width / kStep, image.height / kStep, image.channels);
  for (int y = 0; y < kept.height; ++y)
    for (int x = 0; x < kept.width; ++x)
      for (int c = 0; c < kept.channels; ++c) kept.at(x, y, c) = image.at(kStep * x, kStep * y, c);
  return kept;
}

/// Moves what the matrix projects by (+x, +y) pixels, y down, on a grid of width x height pixels.
Matrix4 shifted(Matrix4 worldToClip, double xPx, double yPx, int width, int height) {
  const double ndcX = kNdcRange * xPx / width;
  const double ndcY = -kNdcRange * yPx / height;
  for (std::size_t column = 0; column < 4; ++column) {
    worldToClip[column] += ndcX * worldToClip[12 + column];
    worldToClip[4 + column] += ndcY * worldToClip[12 + column];
  }
  return worldToClip;
}

nlohmann::json toJson(const Matrix4& matrix) {
  nlohmann::json rows = nlohmann::json::array();
  for (std::size_t r = 0; r < 4; ++r)
    rows.push_back({matrix[4 * r], matrix[4 * r + 1], matrix[4 * r + 2], matrix[4 * r + 3]});
  return rows;
}

class Subsampler {
 public:
  Subsampler(const std::string& input, std::string output)
      : m_sequence(input),
        m_output(std::move(output)),
        m_width(m_sequence.width() / kStep),
        m_height(m_sequence.height() / kStep) {
    if (m_sequence.width() % kStep != 0 || m_sequence.height() % kStep != 0)
      throw quell::Error(quell::ErrorCode::InvalidArgument,
                         {"subsample", input, "even width and height",
                          fmt::format("{}x{}", m_sequence.width(), m_sequence.height())});
    std::filesystem::create_directories(m_output);
  }

  void addFrame(int frame) {
    const quell::io::FrameData data = m_sequence.read(frame);
    for (const ImageSource& source : quell::io::imageSources(1))
      write(source.files.stem, frame, data.*source.image, source.files);
    // What is antialiased over a pixel of the input is not so over one that is four times as large.
    constexpr auto kind = quell::io::ReferenceKind::Centre;
    if (m_sequence.hasReference(frame, kind)) {
      const quell::ImageFiles& color = quell::factsOf(&quell::io::FrameData::radiance).files;
      const quell::io::Reference reference = m_sequence.reference(frame, kind);
      write(quell::io::referenceStem(kind, 'a', color.stem), frame, reference.a, color);
      write(quell::io::referenceStem(kind, 'b', color.stem), frame, reference.b, color);
    }
    using Key = quell::io::CameraKey;
    m_frames.push_back({{nameOf(Key::Frame), frame},
                        {nameOf(Key::ViewProjection), centred(data.camera.worldToClip)},
                        {nameOf(Key::PreviousViewProjection), centred(data.camera.worldToClipPrev)}});
  }

  void writeCameras() const {
    const nlohmann::ordered_json cameras = {
        {"width", m_width}, {"height", m_height}, {nameOf(quell::io::CameraKey::Frames), m_frames}};
    quell::io::writeTextFile(quell::io::joinPath(m_output, quell::io::kCyclesCameraFile),
                             cameras.dump(1) + "\n");
  }

 private:
  nlohmann::json centred(const Matrix4& worldToClip) const {
    return toJson(shifted(worldToClip, kCentreShiftPx, kCentreShiftPx, m_width, m_height));
  }

  void write(const std::string& stem, int frame, const Image& image, const quell::ImageFiles& files) const {
    if (image.empty()) return;
    const std::string name = fmt::format("{}_{:04}.exr", stem, frame);
    quell::io::writeImage(quell::io::joinPath(m_output, name), subsample(image), files);
  }

  quell::io::CyclesSequence m_sequence;
  std::string m_output;
  int m_width;
  int m_height;
  nlohmann::ordered_json m_frames = nlohmann::ordered_json::array();
};

}  // namespace

int main(int argc, char** argv) {
  if (argc != 5) {
    fmt::print(stderr, "usage: quell_subsample_sequence INPUT OUTPUT FIRST LAST\n");
    return 2;
  }
  try {
    Subsampler subsampler(argv[1], argv[2]);
    for (int frame = std::atoi(argv[3]); frame <= std::atoi(argv[4]); ++frame) subsampler.addFrame(frame);
    subsampler.writeCameras();
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 1;
  }
  return 0;
}
