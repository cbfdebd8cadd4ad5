// A rendered sequence as files: the layout of host/io/cycles_sequence.hpp.
//
// For each frame all images of the contract that have files, light as two signals and as a whole (color); for frames
// with a reference ref_a_<stem> and ref_b_<stem> of light alone; camera.json with the matrices; render.json with the
// settings of the rendering.
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
};

class SequenceWriter {
 public:
  /// Creates the directory, or takes one that was begun with the same settings; then writes camera.json for
  /// at least `frameCount` frames and render.json.
  /// Throws Error(FileError) if it cannot be written, Error(InvalidArgument) if it holds another rendering.
  SequenceWriter(std::string directory, const SequenceSettings& settings, int frameCount);

  /// Whether all files of the frame, or of one half ('a' or 'b') of its reference, are there and can be read
  /// to their end.
  bool hasFrame(int frame) const;
  bool hasReference(int frame, char half) const;

  /// color comes last: a reader finds a frame by it. Throws Error(FileError).
  void writeFrame(int frame, const Features& features, const Light& light) const;
  void writeReference(int frame, char half, const Features& features, const Light& light) const;

 private:
  std::string path(const std::string& stem, int frame) const;
  /// Whether the file is there and can be read to its end.
  bool isWhole(const std::string& stem, int frame) const;
  void writeCameras(const SceneEntry& scene, int frameCount) const;

  std::string m_directory;
  SequenceSettings m_settings;
};

}  // namespace quell::render
