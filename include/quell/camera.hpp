// Camera of one frame, as the denoiser needs it to find where a surface point was one frame ago.
#pragma once

#include <quell/api.h>

#include <array>

namespace quell {

/// 4x4 matrix, row-major, for column vectors: clip[r] = sum over c of m[4*r + c] * (x, y, z, 1)[c].
using Matrix4 = std::array<double, 16>;

/// Primary rays may leave the centre of their pixel by at most this, pixels.
constexpr double kMaxJitterPx = 1.0;

/// The camera of this frame and of the frame before it.
///
/// Matrices map world space to clip space in double precision, unjittered. Normalised device coordinates:
/// x right, y up, both in [-1, 1] over the image; clip.w grows with the distance in front of the camera
/// (perspective) or is constant (orthographic). Row 2 (clip.z) is not used.
struct Camera {
  Matrix4 worldToClip{};  ///< this frame
  /// The frame before; any value on the first frame after a history reset. All zero: the worldToClip of the frame that was
  /// denoised before, which the denoiser remembers.
  Matrix4 worldToClipPrev{};

  /// Where inside the pixel the primary rays of this frame went: sample position minus pixel centre, in
  /// pixels, x right, y down, each within kMaxJitterPx. Zero means the pixel centre. History lives on pixel
  /// centres and moves as surfaces do, so neither the offset of the frame before nor offsets of each pixel's own count
  /// there; where there is no position image, positions are made along these rays.
  std::array<double, 2> jitterPx{0.0, 0.0};
};

/// Whether the primary rays of this frame left the centres of their pixels.
inline bool isJittered(const Camera& camera) { return camera.jitterPx != std::array<double, 2>{0.0, 0.0}; }

/// How a matrix lies in memory.
enum class MatrixOrder {
  Rows,  ///< row by row, for column vectors: as Matrix4; also column by column for row vectors
  Columns,  ///< column by column, for column vectors (GLM, OpenGL); also row by row for row vectors (DirectXMath)
};

/// The 16 numbers of a matrix in this order.
QUELL_API Matrix4 toMatrix4(const float* numbers, MatrixOrder order);
/// The same of doubles.
QUELL_API Matrix4 toMatrix4(const double* numbers, MatrixOrder order);

/// world to clip = (view to clip) * (world to view).
QUELL_API Matrix4 product(const Matrix4& viewToClip, const Matrix4& worldToView);

/// World to clip of a pinhole camera; clip.w is the view depth. `up` points up in the picture, any length;
/// `verticalFovDegrees` in (0, 180); `aspect`: width by height. Throws Error(InvalidArgument) where eye and target are one
/// point, `up` lies along the line between them, or a number is out of range.
QUELL_API Matrix4 lookAt(const std::array<double, 3>& eye, const std::array<double, 3>& target,
                         const std::array<double, 3>& up, double verticalFovDegrees, double aspect);

}  // namespace quell
