#include "host/io/pixel_window.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace quell::io {
namespace {

/// clip' = scale * clip + shift * clip.w for one row of a matrix, whose last row stays.
void moveRow(Matrix4& matrix, std::size_t row, double scale, double shift) {
  for (std::size_t column = 0; column < 4; ++column)
    matrix[4 * row + column] = scale * matrix[4 * row + column] + shift * matrix[12 + column];
}

void crop(Matrix4& matrix, const PictureWindows& windows) {
  const PixelWindow &data = windows.data, &display = windows.display;
  const double width = data.width, height = data.height;
  moveRow(matrix, 0, display.width / width, (display.width + 2.0 * (display.x - data.x)) / width - 1.0);
  moveRow(matrix, 1, display.height / height, 1.0 - (display.height + 2.0 * (display.y - data.y)) / height);
}

}  // namespace

std::string toString(const PixelWindow& window) {
  std::string text = fmt::format("{}x{} pixels", window.width, window.height);
  if (window.x != 0 || window.y != 0) text += fmt::format(" from ({}, {}) on", window.x, window.y);
  return text;
}

PixelWindow intersection(const PixelWindow& a, const PixelWindow& b) {
  const int left = std::max(a.x, b.x), top = std::max(a.y, b.y);
  const int right = std::min(a.x + a.width, b.x + b.width);
  const int bottom = std::min(a.y + a.height, b.y + b.height);
  if (right <= left || bottom <= top) return {left, top, 0, 0};
  return {left, top, right - left, bottom - top};
}

Image placed(const Image& image, const PixelWindow& from, const PixelWindow& to) {
  Image result(to.width, to.height, image.channels);
  const PixelWindow common = intersection(from, to);
  for (int y = common.y; y < common.y + common.height; ++y)
    for (int x = common.x; x < common.x + common.width; ++x)
      for (int c = 0; c < image.channels; ++c)
        result.at(x - to.x, y - to.y, c) = image.at(x - from.x, y - from.y, c);
  return result;
}

Camera cropped(Camera camera, const PictureWindows& windows) {
  if (windows.data == windows.display) return camera;
  crop(camera.worldToClip, windows);
  crop(camera.worldToClipPrev, windows);
  return camera;
}

}  // namespace quell::io
