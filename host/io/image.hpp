// A float image in host memory: what the tools read, compare and write.
#pragma once

#include <cstddef>
#include <vector>

namespace quell::io {

/// Row-major, interleaved: value(x, y, c) = pixels[(y * width + x) * channels + c]. (0, 0) is top left.
struct Image {
  int width = 0;
  int height = 0;
  int channels = 0;
  std::vector<float> pixels;

  Image() = default;
  Image(int w, int h, int c, float value = 0.0f)
      : width(w), height(h), channels(c), pixels(std::size_t(w) * std::size_t(h) * std::size_t(c), value) {}

  bool empty() const { return pixels.empty(); }
  float& at(int x, int y, int c) {
    return pixels[(std::size_t(y) * std::size_t(width) + std::size_t(x)) * std::size_t(channels) +
                  std::size_t(c)];
  }
  float at(int x, int y, int c) const { return const_cast<Image*>(this)->at(x, y, c); }
};

}  // namespace quell::io
