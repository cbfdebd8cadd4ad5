// A rendered sequence as files: the layout of host/io/cycles_sequence.hpp and more buffers.
//
// For each frame NNNN: color, diffuse_irradiance, glossy_radiance, albedo, gloss_color, f0, emission, shading_normal
// (half R G B), world_position (float R G B), roughness, hit_distance (half Y), motion (half R G), object_id (32-bit
// unsigned Y); for frames with a reference ref_a_<buffer> and ref_b_<buffer> of color, diffuse_irradiance and
// glossy_radiance (half R G B); camera.json with the matrices; render.json with the settings of the rendering.
#pragma once

#include <string>
#include <vector>

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
  /// Creates the directory, or takes one that was begun with the same settings; then writes camera.json for at least
  /// `frameCount` frames and render.json.
  /// Throws Error(FileError) if it cannot be written, Error(InvalidArgument) if it holds another rendering.
  SequenceWriter(std::string directory, const SequenceSettings& settings, int frameCount);

  /// Whether all files of the frame, or of one half ('a' or 'b') of its reference, are there and can be read to their end.
  bool hasFrame(int frame) const;
  bool hasReference(int frame, char half) const;

  /// color comes last: a reader finds a frame by it. Throws Error(FileError).
  void writeFrame(int frame, const Features& features, const Light& light) const;
  void writeReference(int frame, char half, const Features& features, const Light& light) const;

 private:
  std::string path(const std::string& buffer, int frame) const;
  bool areWhole(const std::vector<std::string>& buffers, int frame) const;
  void writeSettings(int frameCount);
  void writeCameras(const SceneEntry& scene, int frameCount) const;

  std::string m_directory;
  SequenceSettings m_settings;
};

}  // namespace quell::render
