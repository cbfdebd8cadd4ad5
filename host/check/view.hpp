// What a camera matrix says, for points in host memory.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <quell/camera.hpp>
#include <quell/image_view.hpp>

namespace quell::check {

/// First three elements of a row, and the product of a row with (p, 1).
glm::dvec3 rowOf(const Matrix4& matrix, int row);
double clipOf(const Matrix4& matrix, int row, const glm::dvec3& p);

/// Where a point lies in an image, pixels: columns and lines, pixel centres at + 0.5. Nothing behind the camera, or
/// without a finite place.
std::optional<glm::dvec2> project(const Matrix4& worldToClip, const glm::dvec3& p, Size size);

/// A camera as a place and directions, found from rows x, y and w.
struct View {
  bool perspective = false;
  glm::dvec3 eye;  ///< perspective only
  /// Unit length; `forward` of an orthographic camera may point backward.
  glm::dvec3 right, up, forward;
  double depthUnit = 1.0;  ///< clip.w at view depth 1; perspective only

  /// From a surface to the camera, unit length.
  glm::dvec3 towards(const glm::dvec3& p) const;
};

/// Nothing for a matrix that is not finite or cannot be a camera's.
std::optional<View> viewOf(const Matrix4& worldToClip);

/// Where the centre of a pixel (plus jitter) is seen at view depth 1, relative to the eye; perspective cameras only.
glm::dvec3 rayThrough(const Matrix4& worldToClip, const View& view, const glm::dvec2& pixel, Size size);

Matrix4 transposed(const Matrix4& m);
/// Row by row, column by column times a factor.
Matrix4 scaledRows(Matrix4 m, const std::array<double, 4>& factors);
Matrix4 scaledColumns(Matrix4 m, const std::array<double, 4>& factors);
/// Nothing for a singular matrix.
std::optional<Matrix4> inverse(const Matrix4& m);

}  // namespace quell::check
