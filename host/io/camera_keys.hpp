// Names of the entries of camera.json (docs/cameras.md), for what reads and what writes it.
#pragma once

#include <cstddef>

namespace quell::io {

enum class CameraKey {
  Frames,
  Vectors,
  NdcY,
  Frame,
  ViewProjection,
  PreviousViewProjection,
  View,
  Projection,
  Eye,
  Target,
  Up,
  Fov,
  FovAxis,
  Aspect,
  Near,
  Far,
  JitterPx,
  Count
};

constexpr const char* kCameraKeyNames[] = {"frames",
                                           "vectors",
                                           "ndc_y",
                                           "frame",
                                           "view_projection",
                                           "previous_view_projection",
                                           "view",
                                           "projection",
                                           "eye",
                                           "target",
                                           "up",
                                           "fov",
                                           "fov_axis",
                                           "aspect",
                                           "near",
                                           "far",
                                           "jitter_px"};
static_assert(sizeof(kCameraKeyNames) / sizeof(*kCameraKeyNames) == std::size_t(CameraKey::Count));

constexpr const char* nameOf(CameraKey key) { return kCameraKeyNames[std::size_t(key)]; }

}  // namespace quell::io
