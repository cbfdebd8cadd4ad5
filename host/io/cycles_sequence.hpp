// Sequences as rendered with Blender Cycles: one OpenEXR file per buffer and frame, matrices in camera.json.
//
// For each frame NNNN (as frame_files.hpp says): color_NNNN.exr, shading_normal_NNNN.exr and
// world_position_NNNN.exr; for all frames or none the other images of the contract, under the names and with the
// channels that quell/frame_images.h says, and A beside the colour; for two signals diffuse_irradiance_NNNN.exr and glossy_radiance_NNNN.exr,
// light before albedo and gloss colour;
// for any frame: ref_a_color_NNNN.exr and ref_b_color_NNNN.exr, the halves of the reference through pixel centres, and
// ref_aa_a_color_NNNN.exr and ref_aa_b_color_NNNN.exr, those of the antialiased one. Other files are ignored. camera.json: see camera_file.hpp.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "host/io/camera_file.hpp"
#include "host/io/declared_cameras.hpp"
#include "host/io/frame_files.hpp"
#include "host/io/frame_sequence.hpp"
#include "host/io/image_sources.hpp"

namespace quell::io {

class CyclesSequence final : public FrameSequence {
 public:
  /// Checks that all files are there; pixels are read later. The size is that of the first colour image.
  /// `colors`: of the files of the colour those that count; empty: all. Throws Error(FileError): a missing frame or buffer,
  /// a malformed camera.json, a frame missing in it.
  explicit CyclesSequence(std::string directory, int signals = 1,
                          MissingFrames missing = MissingFrames::Refuse, FrameFiles colors = {});

  std::string name() const override { return m_directory; }
  int width() const override { return m_windows.data.width; }
  int height() const override { return m_windows.data.height; }
  std::vector<int> frames() const override { return m_frames; }

  /// Throws Error(InvalidArgument) for a frame that is not there or an image whose size differs from the
  /// first frame's, Error(FileError) for an unreadable file.
  FrameData read(int frame) const override;
  void requireReadable(const std::vector<int>& frames) const override;
  std::string fileOf(int frame, const ImageFiles& files) const override;
  bool hasReference(int frame, ReferenceKind kind) const override;
  Reference reference(int frame, ReferenceKind kind) const override;
  bool jittered() const override;
  std::vector<std::string> describeChannels() const override;

 private:
  const FrameFiles& filesOf(const std::string& stem) const;

  std::string m_directory;
  FrameDirectory m_files;
  std::vector<int> m_frames;
  DeclaredCameras m_cameras;
  PictureWindows m_windows;
  bool m_demodulated = false;
  bool m_hasAlpha = false;             ///< channel A beside the colour
  std::vector<ImageSource> m_sources;  ///< of the images that the directory has
};

}  // namespace quell::io
