// A rendered sequence as files: the layout of host/io/cycles_sequence.hpp.
//
// For each frame all images of the contract that have files, light as two signals and as a whole (color); for frames
// with a reference its files (host/io/reference.hpp), of light alone; camera.json with the matrices and jitter;
// render.json with the settings of the rendering.
#pragma once

#include <string>

#include "host/render/path_tracer.hpp"
#include "host/render/scene_registry.hpp"

namespace quell::render {

/// What decides the pixels of a sequence.
struct SequenceSettings {
  std::string scene;
  Size size;
  int samples = 1;           ///< per pixel
  int referenceSamples = 0;  ///< per pixel and half
  std::uint32_t seed = 1;
  bool jitter = false;  ///< primary rays of the frames leave the pixel centres, by io::jitterPxOf()
};

class SequenceWriter {
 public:
  /// Creates the directory, or takes one that was begun with the same settings; then writes camera.json for
  /// at least `frameCount` frames and render.json.
  /// Throws Error(FileError) if it cannot be written, Error(InvalidArgument) if it holds another rendering.
  SequenceWriter(std::string directory, const SequenceSettings& settings, int frameCount);

  /// Whether all files of the frame, or of one half ('a' or 'b') of a reference, are there and can be read
  /// to their end.
  bool hasFrame(int frame) const;
  bool hasReference(int frame, io::ReferenceKind kind, char half) const;

  /// Data of two signals. color comes last: a reader finds a frame by it. Throws Error(FileError).
  void writeFrame(int frame, const io::FrameData& data) const;
  /// Of the antialiased kind FrameData::combined is enough.
  void writeReference(int frame, io::ReferenceKind kind, char half, const io::FrameData& data) const;

 private:
  std::string path(const std::string& stem, int frame) const;
  /// Whether the file is there and can be read to its end.
  bool isWhole(const std::string& stem, int frame) const;
  void writeCameras(const SceneEntry& scene, int frameCount) const;

  std::string m_directory;
  SequenceSettings m_settings;
};

}  // namespace quell::render
