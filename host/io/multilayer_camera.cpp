#include "host/io/multilayer_camera.hpp"

#include <array>
#include <cmath>
#include <utility>

namespace quell::io {
namespace {

constexpr int kUnknowns = 4;  // of a row: three for the position, one constant
constexpr int kRows = 3;      // clip x, y and w
/// Share of the scene's variance across a plane below which it is one plane: rounding of half floats.
constexpr double kFlatShare = 1e-5;
/// Largest root mean square distance of projected positions from their pixels.
constexpr double kFitPx = 2.0;

using Vector3 = std::array<double, 3>;

bool isSurface(const Image& depth, int x, int y) {
  const float d = depth.at(x, y, 0);
  return d > 0.0f && d < kSkyDepth;  // false for NaN
}

Vector3 positionAt(const Image& image, int x, int y) {
  return {double(image.at(x, y, 0)), double(image.at(x, y, 1)), double(image.at(x, y, 2))};
}

double ndcX(const Image& image, int x) { return (2.0 * x + 1.0) / image.width - 1.0; }
double ndcY(const Image& image, int y) { return 1.0 - (2.0 * y + 1.0) / image.height; }

template <class Work>
void forEachSurface(const Image& position, const Image& depth, const Work& work) {
  for (int y = 0; y < depth.height; ++y)
    for (int x = 0; x < depth.width; ++x)
      if (isSurface(depth, x, y)) work(x, y, positionAt(position, x, y), double(depth.at(x, y, 0)));
}

/// Centre and extent of the positions: the fit is done in these units.
struct Scale {
  Vector3 centre{};
  double size = 0.0;
};

Scale scaleOf(const Image& position, const Image& depth) {
  Scale scale;
  double count = 0.0, squares = 0.0;
  forEachSurface(position, depth, [&](int, int, const Vector3& p, double) {
    for (std::size_t i = 0; i < 3; ++i) scale.centre[i] += p[i];
    count += 1.0;
  });
  for (double& component : scale.centre) component /= count;
  forEachSurface(position, depth, [&](int, int, const Vector3& p, double) {
    for (std::size_t i = 0; i < 3; ++i) squares += std::pow(p[i] - scale.centre[i], 2.0);
  });
  scale.size = std::sqrt(squares / count);
  return scale;
}

/// Normal equations of the three rows side by side.
struct Equations {
  double left[kUnknowns][kUnknowns] = {};
  double right[kUnknowns][kRows] = {};
};

/// Gaussian elimination; the solution replaces `right`. False if a pivot vanishes.
bool solve(Equations& e) {
  for (int column = 0; column < kUnknowns; ++column) {
    int pivot = column;
    for (int row = column + 1; row < kUnknowns; ++row)
      if (std::abs(e.left[row][column]) > std::abs(e.left[pivot][column])) pivot = row;
    if (!(std::abs(e.left[pivot][column]) > kFlatShare)) return false;
    std::swap(e.left[pivot], e.left[column]);
    std::swap(e.right[pivot], e.right[column]);
    for (int row = 0; row < kUnknowns; ++row) {
      if (row == column) continue;
      const double factor = e.left[row][column] / e.left[column][column];
      for (int i = 0; i < kUnknowns; ++i) e.left[row][i] -= factor * e.left[column][i];
      for (int i = 0; i < kRows; ++i) e.right[row][i] -= factor * e.right[column][i];
    }
  }
  for (int row = 0; row < kUnknowns; ++row)
    for (int i = 0; i < kRows; ++i) e.right[row][i] /= e.left[row][row];
  return true;
}

/// Pixels weigh by 1 / depth^2, so that errors count in pixels; the mean weight is 1.
Equations equationsOf(const Image& position, const Image& depth, const Scale& scale) {
  Equations e;
  double weights = 0.0;
  forEachSurface(position, depth, [&](int x, int y, const Vector3& p, double d) {
    const double q[kUnknowns] = {(p[0] - scale.centre[0]) / scale.size, (p[1] - scale.centre[1]) / scale.size,
                                 (p[2] - scale.centre[2]) / scale.size, 1.0};
    const double target[kRows] = {ndcX(depth, x) * d, ndcY(depth, y) * d, d};
    const double weight = 1.0 / (d * d);
    weights += weight;
    for (int i = 0; i < kUnknowns; ++i) {
      for (int j = 0; j < kUnknowns; ++j) e.left[i][j] += weight * q[i] * q[j];
      for (int j = 0; j < kRows; ++j) e.right[i][j] += weight * q[i] * target[j];
    }
  });
  for (int i = 0; i < kUnknowns; ++i) {
    for (double& value : e.left[i]) value /= weights;
    for (double& value : e.right[i]) value /= weights;
  }
  return e;
}

double clipRow(const Matrix4& m, std::size_t row, const Vector3& p) {
  return m[4 * row] * p[0] + m[4 * row + 1] * p[1] + m[4 * row + 2] * p[2] + m[4 * row + 3];
}

double rmsPx(const Matrix4& m, const Image& position, const Image& depth) {
  double sum = 0.0, count = 0.0;
  forEachSurface(position, depth, [&](int x, int y, const Vector3& p, double) {
    const double w = clipRow(m, 3, p);
    const double errorX = (clipRow(m, 0, p) / w - ndcX(depth, x)) * 0.5 * depth.width;
    const double errorY = (clipRow(m, 1, p) / w - ndcY(depth, y)) * 0.5 * depth.height;
    sum += errorX * errorX + errorY * errorY;
    count += 1.0;
  });
  return std::sqrt(sum / count);
}

Vector3 cross(const Vector3& a, const Vector3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
double dot(const Vector3& a, const Vector3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

}  // namespace

std::optional<Matrix4> findCamera(const Image& positionWorld, const Image& depth) {
  const Scale scale = scaleOf(positionWorld, depth);
  if (!(scale.size > 0.0)) return std::nullopt;  // NaN without any surface
  Equations e = equationsOf(positionWorld, depth, scale);
  if (!solve(e)) return std::nullopt;
  Matrix4 matrix{};
  constexpr std::size_t kMatrixRows[kRows] = {0, 1, 3};
  for (int row = 0; row < kRows; ++row) {
    double* out = &matrix[4 * kMatrixRows[row]];
    out[3] = e.right[3][row];
    for (int axis = 0; axis < 3; ++axis) {
      out[axis] = e.right[axis][row] / scale.size;
      out[3] -= out[axis] * scale.centre[std::size_t(axis)];
    }
  }
  if (!(rmsPx(matrix, positionWorld, depth) < kFitPx)) return std::nullopt;
  return matrix;
}

std::optional<Image> positionsFromDepth(const Matrix4& m, const Image& depth) {
  const Vector3 rowX = {m[0], m[1], m[2]}, rowY = {m[4], m[5], m[6]}, rowW = {m[12], m[13], m[14]};
  const double unit = std::sqrt(dot(rowW, rowW));  // clip.w at view depth 1
  const double determinant = dot(rowX, cross(rowY, rowW));
  if (!(std::abs(determinant) > 0.0)) return std::nullopt;
  const Vector3 byX = cross(rowY, rowW), byY = cross(rowW, rowX), byW = cross(rowX, rowY);
  Image position(depth.width, depth.height, 3);
  for (int y = 0; y < depth.height; ++y) {
    for (int x = 0; x < depth.width; ++x) {
      if (!isSurface(depth, x, y)) continue;
      const double w = double(depth.at(x, y, 0)) * unit;
      const double rightX = ndcX(depth, x) * w - m[3], rightY = ndcY(depth, y) * w - m[7];
      const double rightW = w - m[15];
      for (std::size_t axis = 0; axis < 3; ++axis)
        position.at(x, y, int(axis)) =
            float((rightX * byX[axis] + rightY * byY[axis] + rightW * byW[axis]) / determinant);
    }
  }
  return position;
}

}  // namespace quell::io
