// Cameras of a sequence as camera.json has them; docs/cameras.md, and data/camera.schema.json as a JSON Schema.
#pragma once

#include <map>
#include <optional>
#include <quell/camera.hpp>
#include <string>

#include "host/io/camera_convention.hpp"
#include "host/io/depth_kind.hpp"

namespace quell::io {

/// The file of a directory that holds them.
constexpr char kCyclesCameraFile[] = "camera.json";

struct CameraFile {
  std::map<int, Camera> cameras;  ///< by frame, for the whole picture, as column vectors have them
  std::map<int, DepthRange> ranges;
  /// Whether the file says how its matrices are meant, or has none.
  bool declared = false;
};

/// `aspect`: width by height of the picture in pixels, for cameras of a field of view; an entry may have another one.
/// Throws Error(FileError) naming the file and the entry: not JSON, an entry that is missing or of another form, a frame
/// that is there twice, a jitter beyond kMaxJitterPx, a camera that looks nowhere.
CameraFile readCameraFile(const std::string& path, double aspect);

/// The frames as above, without what looks for a camera: throws Error(FileError) naming the first of them without one.
void requireCameras(const CameraFile& file, const std::vector<int>& frames, const std::string& path);

}  // namespace quell::io
