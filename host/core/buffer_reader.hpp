// Buffers of a method in host memory.
#pragma once

#include <quell/denoiser.hpp>

#include "host/core/schedule.hpp"

namespace quell {

/// Where pixel (x, y) of a plane lies among the elements of its buffer.
std::size_t planeElement(const PlaneParams& planes, int plane, int x, int y);

/// Reads a buffer without its margins, converted to floats; blocks.
BufferContent readBufferContent(const cl::CommandQueue& queue, const cl::Buffer& memory,
                                const BufferSpec& spec, Size size);

/// Calls work(element of the buffer, index into BufferContent::values) for everything that is not margin.
template <class Work>
void forEachElement(const BufferSpec& spec, Size size, Work&& work) {
  std::size_t i = 0;
  if (spec.extent.planes == 0) {
    for (; i < spec.extent.elements; ++i) work(i, i);
    return;
  }
  const PlaneParams planes = makePlanes(size);
  for (int plane = 0; plane < spec.extent.planes; ++plane)
    for (int y = 0; y < size.height; ++y)
      for (int x = 0; x < size.width; ++x) work(planeElement(planes, plane, x, y), i++);
}

}  // namespace quell
