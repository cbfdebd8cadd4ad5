#include "host/core/history_transfer.hpp"

#include <cstring>

#include "host/core/buffer_reader.hpp"

namespace quell {
namespace {

using Bytes = std::vector<unsigned char>;

std::size_t bytesOf(const BufferSpec& spec, Size size) {
  return elementCount(spec, size) * elementBytes(spec.element);
}

/// Pixel of `oldCount` whose centre is nearest to that of pixel `i` of `newCount`.
int nearest(int i, int oldCount, int newCount) {
  return static_cast<int>((2 * std::int64_t{i} + 1) * oldCount / (2 * std::int64_t{newCount}));
}

void copyOrResample(const cl::CommandQueue& queue, const BufferSpec& spec, const cl::Buffer& source,
                    Size oldSize, const cl::Buffer& target, Size newSize) {
  Bytes bytes(bytesOf(spec, oldSize));
  queue.enqueueReadBuffer(source, CL_TRUE, 0, bytes.size(), bytes.data());
  if (oldSize != newSize) bytes = resampleNearest(bytes, spec, oldSize, newSize);
  queue.enqueueWriteBuffer(target, CL_TRUE, 0, bytes.size(), bytes.data());
}

}  // namespace

Bytes resampleNearest(const Bytes& old, const BufferSpec& spec, Size oldSize, Size newSize) {
  const PlaneParams oldPlanes = makePlanes(oldSize), newPlanes = makePlanes(newSize);
  const std::size_t element = elementBytes(spec.element);
  Bytes bytes(bytesOf(spec, newSize));
  for (int plane = 0; plane < spec.extent.planes; ++plane)
    for (int y = 0; y < newSize.height; ++y)
      for (int x = 0; x < newSize.width; ++x)
        std::memcpy(&bytes[planeElement(newPlanes, plane, x, y) * element],
                    &old[planeElement(oldPlanes, plane, nearest(x, oldSize.width, newSize.width),
                                      nearest(y, oldSize.height, newSize.height)) *
                         element],
                    element);
  return bytes;
}

bool carryHistory(const cl::CommandQueue& queue, const Pipeline& from, const Pipeline& to, int parity) {
  const Size oldSize = from.renderSize(), newSize = to.configuration().size();
  for (std::size_t i = 0; i < to.plan().buffers.size(); ++i) {
    const BufferSpec& spec = to.plan().buffers[i];
    if (!spec.history) continue;
    const cl::Buffer& target = to.buffers().current(static_cast<int>(i), parity);
    const int old = from.plan().find(spec.name);
    const BufferSpec* source = old < 0 ? nullptr : &from.plan().buffers[static_cast<std::size_t>(old)];
    const bool same = source != nullptr && source->history && source->element == spec.element &&
                      source->extent == spec.extent;
    if (spec.extent.planes > 0 && !same) return false;
    if (same && (spec.extent.planes > 0 || oldSize == newSize)) {
      copyOrResample(queue, spec, from.buffers().current(old, parity), oldSize, target, newSize);
    } else {
      const Bytes zeros(bytesOf(spec, newSize));
      queue.enqueueWriteBuffer(target, CL_TRUE, 0, zeros.size(), zeros.data());
    }
  }
  return true;
}

}  // namespace quell
