// Planes of an image in host memory, without margins: what stages keep between them.
#pragma once

#include <algorithm>
#include <cstddef>
#include <quell/image_view.hpp>
#include <vector>

namespace quell::tests {

/// value(plane, x, y) = values[(plane * height + y) * width + x]. A plain array is one row of one plane.
template <class Value>
struct BasicPlanes {
  int width = 0;
  int height = 0;
  int count = 0;
  std::vector<Value> values;

  BasicPlanes() = default;
  BasicPlanes(Size size, int planes, Value value = Value())
      : width(size.width),
        height(size.height),
        count(planes),
        values(std::size_t(size.width) * std::size_t(size.height) * std::size_t(planes), value) {}

  Size size() const { return {width, height}; }
  std::size_t index(int plane, int x, int y) const {
    return (std::size_t(plane) * std::size_t(height) + std::size_t(y)) * std::size_t(width) + std::size_t(x);
  }
  Value& at(int plane, int x, int y) { return values[index(plane, x, y)]; }
  const Value& at(int plane, int x, int y) const { return values[index(plane, x, y)]; }
};

using Planes = BasicPlanes<float>;        ///< as the device holds them; bytes are converted
using ExactPlanes = BasicPlanes<double>;  ///< as the oracles compute them

/// `count` of the planes, from `first` on.
template <class Value>
BasicPlanes<Value> planesOf(const BasicPlanes<Value>& planes, int first, int count) {
  BasicPlanes<Value> part(planes.size(), count);
  const auto start = planes.values.begin() + static_cast<std::ptrdiff_t>(planes.index(first, 0, 0));
  std::copy(start, start + static_cast<std::ptrdiff_t>(part.values.size()), part.values.begin());
  return part;
}

inline void fill(Planes& planes, float value) {
  std::fill(planes.values.begin(), planes.values.end(), value);
}

/// Calls work(x, y) for every pixel.
template <class Work>
void forEachPixel(Size size, Work&& work) {
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x) work(x, y);
}

}  // namespace quell::tests
