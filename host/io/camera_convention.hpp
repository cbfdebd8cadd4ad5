// Which of the ways to write a matrix down a renderer chose: found by where positions project to.
#pragma once

#include <array>
#include <optional>
#include <quell/camera.hpp>
#include <vector>

#include "host/io/image.hpp"

namespace quell::io {

/// A way to read a matrix.
struct MatrixReading {
  const char* name;  ///< for messages, as "transposed"
  bool transposed;
  bool yDown;
};

/// The ways, that of quell::Camera first.
const std::vector<MatrixReading>& matrixReadings();

/// The matrix in the convention of quell::Camera if it was written down so.
Matrix4 readAs(const MatrixReading& reading, const Matrix4& matrix);

/// Median distance between pixels and where the matrix puts the positions (3 channels) that they show, pixels; infinite for
/// a matrix that has them behind the camera. Pixels at the origin or without finite positions are left out; nothing without
/// any other. `jitterPx` as Camera has it.
std::optional<double> projectionErrorPx(const Matrix4& worldToClip, const std::array<double, 2>& jitterPx,
                                        const Image& positionWorld);

/// Whether such an error is that of a right camera: filters and jitter put positions off by up to two pixels, in small
/// pictures by no more than a share.
bool fits(double errorPx, const Image& picture);

}  // namespace quell::io
