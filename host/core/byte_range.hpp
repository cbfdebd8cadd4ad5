// Which bytes of a buffer an image covers.
#pragma once

#include <cstddef>
#include <quell/image_view.hpp>

namespace quell {

struct ByteRange {
  std::size_t begin = 0;
  std::size_t size = 0;
};

/// From the first byte of the first row in memory to the last of the last, whichever of them is on top.
ByteRange rangeOf(const ImageView& view, Size size);

}  // namespace quell
