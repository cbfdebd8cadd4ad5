#include "host/render/pinhole_camera.hpp"

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "host/render/pack.hpp"

namespace quell::render {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr glm::dvec3 kUp{0.0, 0.0, 1.0};
// Only clip.z depends on these (m), which nobody reads.
constexpr double kNearM = 0.1;
constexpr double kFarM = 100.0;

double fieldOfViewRad(const PinholeCamera& camera) { return camera.fieldOfViewDeg * kPi / 180.0; }

glm::dmat4 viewProjection(const PinholeCamera& camera, int width, int height) {
  return glm::perspectiveRH_NO(fieldOfViewRad(camera), double(width) / height, kNearM, kFarM) *
         glm::lookAtRH(camera.eye, camera.target, kUp);
}

/// Row `row` of world-to-clip for positions relative to the eye.
QuellFloat4 clipRow(const glm::dmat4& m, int row, const glm::dvec3& eye) {
  const glm::dvec3 linear{m[0][row], m[1][row], m[2][row]};
  return pack(linear, glm::dot(linear, eye) + m[3][row]);
}

}  // namespace

Matrix4 worldToClip(const PinholeCamera& camera, int width, int height) {
  const glm::dmat4 columnMajor = viewProjection(camera, width, height);
  Matrix4 rowMajor{};
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column)
      rowMajor[std::size_t(4 * row + column)] = columnMajor[column][row];
  return rowMajor;
}

double pixelAngle(const PinholeCamera& camera, int height) {
  return 2.0 * std::tan(0.5 * fieldOfViewRad(camera)) / height;
}

RenderCamera makeRenderCamera(const PinholeCamera& camera, int width, int height) {
  const glm::dvec3 forward = glm::normalize(camera.target - camera.eye);
  const glm::dvec3 right = glm::normalize(glm::cross(forward, kUp));
  const glm::dvec3 up = glm::cross(right, forward);
  const double pixel = pixelAngle(camera, height);
  const glm::dmat4 clip = viewProjection(camera, width, height);
  RenderCamera packed{};
  packed.eye = pack(camera.eye);
  // Pixels from the image's middle to where the first pixel is seen through, x right, y down.
  const double firstX = 0.5 * (1.0 - width) + camera.jitterPx[0];
  const double firstY = 0.5 * (1.0 - height) + camera.jitterPx[1];
  packed.corner = pack(forward + pixel * (firstX * right - firstY * up));
  packed.stepX = pack(pixel * right);
  packed.stepY = pack(-pixel * up);
  packed.clip[0] = clipRow(clip, 0, camera.eye);
  packed.clip[1] = clipRow(clip, 1, camera.eye);
  packed.clip[2] = clipRow(clip, 3, camera.eye);
  return packed;
}

}  // namespace quell::render
