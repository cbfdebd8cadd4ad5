// The cameras of camera.json for the frames of a sequence, read as the frames' positions show that they are meant.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "host/io/camera_file.hpp"
#include "host/io/frame_sequence.hpp"
#include "host/io/pixel_window.hpp"

namespace quell::io {

class DeclaredCameras {
 public:
  /// No cameras.
  DeclaredCameras() = default;
  /// `windows` of the frames: the file has cameras of the display window. Throws what readCameraFile() throws, and
  /// Error(FileError) naming the first of `frames` that has none.
  DeclaredCameras(std::string path, const PictureWindows& windows, const std::vector<int>& frames);

  bool empty() const { return m_file.cameras.empty(); }
  bool jittered(const std::vector<int>& frames) const;
  /// Of a frame's depth buffer, if the file says so.
  std::optional<DepthRange> rangeOf(int frame) const;

  /// Sets the camera of one of the frames. Where the file does not say how its matrices are meant and `positions` (3
  /// channels; called until a frame with surfaces has been seen) do not project to their pixels, matrices are read in
  /// another way that fits, transposed or with y down, with a warning.
  void setCamera(FrameData& frame, const std::function<Image()>& positions) const;

 private:
  Camera readCamera(int frame, const MatrixReading& reading) const;
  void settle(const FrameData& frame, const Image& positions) const;

  std::string m_path;
  PictureWindows m_windows;
  CameraFile m_file;
  mutable std::optional<MatrixReading> m_reading;  ///< what the first frame with surfaces shows
  mutable double m_errorPx = 0.0;                  ///< of that frame, if matrices are read as they stand
};

}  // namespace quell::io
