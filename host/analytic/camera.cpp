#include "host/analytic/camera.hpp"

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

namespace quell::io::analytic {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr glm::dvec3 kUp{0.0, 0.0, 1.0};

// Vertical field of view. At 720 rows one radian at the image centre is 360 / tan(25 deg) = 772 pixels.
constexpr double kFieldOfViewRad = 50.0 * kPi / 180.0;

// The path: eye and heading swing about the middle of the room. Fastest at time 0: 0.023 m per frame sideways
// (3 pixels at 6 m, 1280x720) and 0.08 degrees of turn (1 pixel).
constexpr glm::dvec3 kEyeMiddle{0.1, -4.3, 1.6};
constexpr double kSwingM = 0.6;
constexpr double kSwingPeriodFrames = 164.0;
constexpr double kTurnRad = 1.5 * kPi / 180.0;
constexpr double kTurnPeriodFrames = 120.0;
constexpr double kDownwardRad = 4.0 * kPi / 180.0;

// Only clip.z depends on these (m), which nobody reads.
constexpr double kNearM = 0.1;
constexpr double kFarM = 100.0;

}  // namespace

RoomCamera::RoomCamera(double timeFrames, int width, int height)
    : m_width(width), m_height(height), m_eye(kEyeMiddle) {
  m_eye.x += kSwingM * std::sin(2.0 * kPi * timeFrames / kSwingPeriodFrames);
  const double heading = kTurnRad * std::sin(2.0 * kPi * timeFrames / kTurnPeriodFrames);
  m_forward = {std::sin(heading) * std::cos(kDownwardRad), std::cos(heading) * std::cos(kDownwardRad),
               -std::sin(kDownwardRad)};
}

Ray RoomCamera::rayThrough(double x, double y) const {
  const glm::dvec3 right = glm::normalize(glm::cross(m_forward, kUp));
  const glm::dvec3 up = glm::cross(right, m_forward);
  const double pixelSize = 2.0 * std::tan(0.5 * kFieldOfViewRad) / m_height;  // on the plane 1 m ahead
  const double sideways = (x + 0.5 - 0.5 * m_width) * pixelSize;
  const double upwards = (0.5 * m_height - y - 0.5) * pixelSize;
  return {m_eye, glm::normalize(m_forward + sideways * right + upwards * up)};
}

Matrix4 RoomCamera::worldToClip(const glm::dvec3& worldOffset) const {
  const glm::dmat4 moveBack = glm::translate(glm::dmat4(1.0), -worldOffset);
  const glm::dmat4 view = glm::lookAtRH(m_eye, m_eye + m_forward, kUp);
  const glm::dmat4 projection =
      glm::perspectiveRH_NO(kFieldOfViewRad, double(m_width) / m_height, kNearM, kFarM);
  const glm::dmat4 columnMajor = projection * view * moveBack;
  Matrix4 rowMajor{};
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column)
      rowMajor[std::size_t(4 * row + column)] = columnMajor[column][row];
  }
  return rowMajor;
}

}  // namespace quell::io::analytic
