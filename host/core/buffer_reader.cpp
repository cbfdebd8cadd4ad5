#include "host/core/buffer_reader.hpp"

#include <CL/cl_half.h>

#include <stdexcept>

namespace quell {
namespace {

// Of a type of its own: cl_half is an integer.
struct Half {
  cl_half bits;
  explicit operator float() const { return cl_half_to_float(bits); }
};

template <class Value>
void readAs(const cl::CommandQueue& queue, const cl::Buffer& memory, const BufferSpec& spec, Size size,
            std::vector<float>& values) {
  std::vector<Value> elements(elementCount(spec, size));
  queue.enqueueReadBuffer(memory, CL_TRUE, 0, elements.size() * sizeof(Value), elements.data());
  forEachElement(spec, size, [&](std::size_t element, std::size_t i) {
    values[i] = static_cast<float>(elements[element]);
  });
}

}  // namespace

std::size_t planeElement(const PlaneParams& planes, int plane, int x, int y) {
  return static_cast<std::size_t>(plane) * static_cast<std::size_t>(planes.stride) +
         static_cast<std::size_t>(y + QUELL_PLANE_MARGIN_ROWS) * static_cast<std::size_t>(planes.pitch) +
         QUELL_PLANE_MARGIN + static_cast<std::size_t>(x);
}

BufferContent readBufferContent(const cl::CommandQueue& queue, const cl::Buffer& memory,
                                const BufferSpec& spec, Size size) {
  BufferContent content;
  content.name = spec.name;
  const bool image = spec.extent.planes > 0;
  content.width = image ? size.width : static_cast<int>(spec.extent.elements);
  content.height = image ? size.height : 1;
  content.planes = image ? spec.extent.planes : 1;
  content.values.resize(static_cast<std::size_t>(content.width) * static_cast<std::size_t>(content.height) *
                        static_cast<std::size_t>(content.planes));
  switch (spec.element) {
    case Element::Float32:
      readAs<cl_float>(queue, memory, spec, size, content.values);
      break;
    case Element::UInt8:
      readAs<cl_uchar>(queue, memory, spec, size, content.values);
      break;
    case Element::Int32:
      readAs<cl_int>(queue, memory, spec, size, content.values);
      break;
    case Element::Float16:
      readAs<Half>(queue, memory, spec, size, content.values);
      break;
    case Element::Float32x4:  // only tables, which are no buffers of a method
      throw std::logic_error("readBuffer, " + spec.name + ": expected numbers, got vectors");
  }
  return content;
}

}  // namespace quell
