#include "host/core/byte_range.hpp"

#include <cstdlib>

namespace quell {

ByteRange rangeOf(const ImageView& view, Size size) {
  const std::ptrdiff_t pitch = view.rowPitch(size.width);
  const std::size_t below =
      static_cast<std::size_t>(size.height - 1) * static_cast<std::size_t>(std::abs(pitch));
  return {view.offsetBytes - (pitch < 0 ? below : 0), below + view.rowBytes(size.width)};
}

}  // namespace quell
