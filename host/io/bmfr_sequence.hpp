// Sequences in the layout published with Koskela et al. 2019, "Blockwise Multi-Order Feature Regression for
// Real-Time Path-Tracing Reconstruction" (BMFR).
//
// Per frame n (from 0, as frame_files.hpp says): color<n>.exr, shading_normal<n>.exr, world_position<n>.exr,
// albedo<n>.exr, three channels each; optionally reference<n>.exr, of rays that went where those of the noisy frames did:
// antialiased where they are jittered. The colour has albedo divided out already,
// so FrameData::demodulated is true. camera_matrices.h is a C header with camera_matrices[N][4][4],
// pixel_offsets[N][2] and, optionally, the two limits position_limit_squared and normal_limit_squared.
//
// The published host code reads it so, for frame n with matrix m of frame n-1 (frame 0: its own) and offset o
// of frame n: clip.x = m[0][0] x + m[1][0] y + m[2][0] z + m[3][0], y and w alike from m[.][1] and m[.][3];
//   previous column = (ndc.x + 1) / 2 * width - o.x,   previous row = (ndc.y + 1) / 2 * height - (1 - o.y).
// Its ndc y points down. In the convention of quell::Camera that is: matrix transposed, y row negated,
// jitter = (o.x - 0.5, 0.5 - o.y).
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "host/io/frame_files.hpp"
#include "host/io/frame_sequence.hpp"

namespace quell::io {

/// The file of a directory that marks this layout.
constexpr char kBmfrCameraFile[] = "camera_matrices.h";

class BmfrSequence final : public FrameSequence {
 public:
  /// Checks that all files are there; pixels are read later. The size is that of the first colour image.
  /// Throws Error(FileError): a missing frame or buffer, a malformed header, one with too few matrices, or a
  /// frame number below 0.
  explicit BmfrSequence(std::string directory, MissingFrames missing = MissingFrames::Refuse,
                        FrameFiles colors = {});

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
  std::optional<HistoryLimits> historyLimits() const override { return m_limits; }

 private:
  void readCameraHeader();
  Camera cameraOf(int frame) const;

  const FrameFiles& filesOf(const ImageFiles& files) const;

  std::string m_directory;
  FrameDirectory m_files;
  std::vector<int> m_frames;
  std::vector<Matrix4> m_worldToClip;             // by frame number
  std::vector<std::array<double, 2>> m_jitterPx;  // by frame number, as quell::Camera has it
  std::optional<HistoryLimits> m_limits;
  PictureWindows m_windows;
};

}  // namespace quell::io
