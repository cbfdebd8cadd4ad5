#include "host/check/camera_candidates.hpp"

#include <glm/geometric.hpp>

namespace quell::check {
namespace {

using Candidate = std::optional<Matrix4>;

const Matrix4& given(const Context& context) { return context.now.camera.worldToClip; }

/// Takes points of a space whose axes are `x`, `y` and `z` and whose origin is the eye.
Candidate fromEye(const Context& context, const glm::dvec3& x, const glm::dvec3& y, const glm::dvec3& z) {
  if (!context.view || !context.view->perspective) return std::nullopt;
  Matrix4 matrix{};
  for (int row = 0; row < 4; ++row) {
    const glm::dvec3 r = rowOf(given(context), row);
    const double elements[] = {glm::dot(r, x), glm::dot(r, y), glm::dot(r, z)};
    for (std::size_t c = 0; c < 3; ++c) matrix[4 * std::size_t(row) + c] = elements[c];
  }
  return matrix;
}

Candidate inViewSpace(const Context& context, double forward) {
  if (!context.view) return std::nullopt;
  return fromEye(context, context.view->right, context.view->up, forward * context.view->forward);
}

Candidate relativeToEye(const Context& context) {
  return fromEye(context, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0});
}

/// y and z change places, one of them with its sign.
Candidate exchanged(const Context& context, double ySign, double zSign) {
  Matrix4 matrix = given(context);
  for (std::size_t row = 0; row < 4; ++row) {
    matrix[4 * row + 1] = ySign * given(context)[4 * row + 2];
    matrix[4 * row + 2] = zSign * given(context)[4 * row + 1];
  }
  return matrix;
}

/// The angle that was meant for the width taken for the height, or the other way round.
Candidate otherFovAxis(const Context& context, bool wasWidth) {
  const double aspect = double(context.size.width) / context.size.height;
  const double factor = wasWidth ? aspect : 1.0 / aspect;
  return scaledRows(given(context), {factor, factor, 1, 1});
}

constexpr char kFovAxis[] =
    "let the angle span the other side of the picture: fov_axis in camera.json (Blender: \"larger\")";
constexpr char kTranspose[] =
    "transpose all matrices: row-major, for column vectors (GLM and OpenGL keep columns)";
constexpr char kFlip[] = "turn the rows of all images over, or negate row 1 of both matrices";
constexpr char kWorld[] = "give positions in world space, the space that the matrices start from";
constexpr char kAxes[] = "give positions and matrices in one world; one exporter has turned its axes";

std::vector<CameraCandidate> otherMatrices() {
  return {
      {"camera-transposed", "camera", "with the matrices transposed", kTranspose,
       [](const Context& c) -> Candidate { return transposed(given(c)); }},
      {"image-flipped-y", "camera", "with y of the image turned over (rows bottom up, or y of NDC down)",
       kFlip,
       [](const Context& c) -> Candidate {
         return scaledRows(given(c), {1, -1, 1, 1});
       }},
      {"image-flipped-x", "camera", "with x of the image turned over",
       "turn the columns of all images over, or negate row 0 of both matrices",
       [](const Context& c) -> Candidate {
         return scaledRows(given(c), {-1, 1, 1, 1});
       }},
      {"image-rotated", "camera", "with the image turned by 180 degrees",
       "turn all images, or negate rows 0 and 1 of both matrices",
       [](const Context& c) -> Candidate {
         return scaledRows(given(c), {-1, -1, 1, 1});
       }},
      {"camera-negated", "camera", "with the matrices negated (clip.w below 0 in front of the camera)",
       "negate all elements of both matrices, or pass a projection for a camera that looks the other way "
       "along z",
       [](const Context& c) -> Candidate {
         return scaledRows(given(c), {-1, -1, -1, -1});
       }},
      {"camera-fov-axis", "camera", "with the field of view across the width instead of the height", kFovAxis,
       [](const Context& c) { return otherFovAxis(c, true); }},
      {"camera-fov-axis", "camera", "with the field of view across the height instead of the width", kFovAxis,
       [](const Context& c) { return otherFovAxis(c, false); }},
      {"camera-swapped", "camera", "with the matrix of the frame before",
       "exchange worldToClip and worldToClipPrev, or give the features of this frame",
       [](const Context& c) -> Candidate { return c.now.camera.worldToClipPrev; }},
      {"camera-transposed-flipped-y", "camera", "with the matrices transposed and y of the image turned over",
       "transpose all matrices and negate row 1 of both, or turn the rows of all images over",
       [](const Context& c) -> Candidate {
         return scaledRows(transposed(given(c)), {1, -1, 1, 1});
       }},
      {"camera-inverse", "camera", "with the inverse matrices",
       "pass the matrices from world to clip space, not back",
       [](const Context& c) { return inverse(given(c)); }},
      {"camera-inverse-transposed", "camera", "with the matrices inverted and transposed",
       "pass the matrices from world to clip space, row-major",
       [](const Context& c) { return inverse(transposed(given(c))); }},
  };
}

std::vector<CameraCandidate> otherPositions() {
  return {
      {"position-view-space", "positionWorld", "as positions in view space (z backward)", kWorld,
       [](const Context& c) { return inViewSpace(c, -1.0); }},
      {"position-view-space", "positionWorld", "as positions in view space (z forward)", kWorld,
       [](const Context& c) { return inViewSpace(c, 1.0); }},
      {"position-camera-relative", "positionWorld", "as positions relative to the camera",
       "add the camera's position", [](const Context& c) { return relativeToEye(c); }},
      {"position-axes", "positionWorld", "with z of the positions negated", kAxes,
       [](const Context& c) -> Candidate {
         return scaledColumns(given(c), {1, 1, -1, 1});
       }},
      {"position-axes", "positionWorld", "with y of the positions negated", kAxes,
       [](const Context& c) -> Candidate {
         return scaledColumns(given(c), {1, -1, 1, 1});
       }},
      {"position-axes", "positionWorld", "with x of the positions negated", kAxes,
       [](const Context& c) -> Candidate {
         return scaledColumns(given(c), {-1, 1, 1, 1});
       }},
      {"position-axes", "positionWorld", "as positions whose y is up, with matrices whose z is up", kAxes,
       [](const Context& c) { return exchanged(c, 1.0, -1.0); }},
      {"position-axes", "positionWorld", "as positions whose z is up, with matrices whose y is up", kAxes,
       [](const Context& c) { return exchanged(c, -1.0, 1.0); }},
  };
}

std::vector<CameraCandidate> joined(std::vector<CameraCandidate> one,
                                    const std::vector<CameraCandidate>& other) {
  one.insert(one.end(), other.begin(), other.end());
  return one;
}

}  // namespace

const std::vector<CameraCandidate>& cameraCandidates() {
  static const std::vector<CameraCandidate> candidates = joined(otherMatrices(), otherPositions());
  return candidates;
}

}  // namespace quell::check
