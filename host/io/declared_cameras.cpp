#include "host/io/declared_cameras.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace quell::io {

DeclaredCameras::DeclaredCameras(std::string path, const PictureWindows& windows,
                                 const std::vector<int>& frames)
    : m_path(std::move(path)),
      m_windows(windows),
      m_file(readCameraFile(m_path, double(windows.display.width) / windows.display.height)) {
  requireCameras(m_file, frames, m_path);
  if (m_file.declared) m_reading = matrixReadings().front();
}

bool DeclaredCameras::jittered(const std::vector<int>& frames) const {
  return std::any_of(frames.begin(), frames.end(),
                     [this](int frame) { return isJittered(m_file.cameras.at(frame)); });
}

std::optional<DepthRange> DeclaredCameras::rangeOf(int frame) const {
  const auto found = m_file.ranges.find(frame);
  return found == m_file.ranges.end() ? std::nullopt : std::optional(found->second);
}

Camera DeclaredCameras::readCamera(int frame, const MatrixReading& reading) const {
  Camera camera = m_file.cameras.at(frame);
  camera.worldToClip = readAs(reading, camera.worldToClip);
  camera.worldToClipPrev = readAs(reading, camera.worldToClipPrev);
  return cropped(camera, m_windows);
}

void DeclaredCameras::settle(const FrameData& frame, const Image& positions) const {
  for (const MatrixReading& reading : matrixReadings()) {
    const Camera camera = readCamera(frame.number, reading);
    const auto error = projectionErrorPx(camera.worldToClip, camera.jitterPx, positions);
    if (!error) return;  // no surfaces to judge by
    if (&reading == &matrixReadings().front()) m_errorPx = *error;
    if (fits(*error, positions)) {
      m_reading = reading;
      return;
    }
  }
  m_reading = matrixReadings().front();  // none fits: it is not for want of transposing
}

void DeclaredCameras::setCamera(FrameData& frame, const std::function<Image()>& positions) const {
  if (!m_reading) settle(frame, positions());
  const MatrixReading& asItStands = matrixReadings().front();
  const MatrixReading& reading = m_reading ? *m_reading : asItStands;
  frame.camera = readCamera(frame.number, reading);
  if (!reading.transposed && !reading.yDown) return;
  const std::string off = std::isfinite(m_errorPx) ? fmt::format("{:.1f} pixels off", m_errorPx)
                                                   : std::string("behind the camera");
  const char* vectors = reading.transposed ? "\"vectors\": \"row\"" : "";
  const char* comma = reading.transposed && reading.yDown ? ", " : "";
  const char* ndcY = reading.yDown ? "\"ndc_y\": \"down\"" : "";
  frame.warnings.push_back(
      {FrameWarning::Kind::CameraConvention, m_path, "matrices for column vectors, y up",
       fmt::format("ones that put surfaces {}, but not {}", off, reading.name),
       fmt::format("reads them so; {}{}{} in the file would say it", vectors, comma, ndcY)});
}

}  // namespace quell::io
