// The camera of the built-in test scene and its smooth path through the room.
#pragma once

#include <glm/glm.hpp>
#include <quell/camera.hpp>

#include "host/analytic/scene.hpp"

namespace quell::io::analytic {

/// Perspective camera without jitter; z up, metres.
class RoomCamera {
 public:
  /// The camera at a time on its path, in frames (any value); width and height in pixels, >= 1.
  RoomCamera(double timeFrames, int width, int height);

  /// The ray through a place in the image, pixels; (0, 0) is the centre of the pixel at the top left.
  Ray rayThrough(double x, double y) const;

  /// World to clip as quell::Camera wants it, for a world moved by `worldOffset` (m).
  Matrix4 worldToClip(const glm::dvec3& worldOffset) const;

 private:
  int m_width;
  int m_height;
  glm::dvec3 m_eye;
  glm::dvec3 m_forward;
};

}  // namespace quell::io::analytic
