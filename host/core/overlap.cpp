#include "host/core/overlap.hpp"

#include <CL/cl.h>

#include <array>
#include <cstdlib>
#include <tuple>

#include "host/core/byte_range.hpp"
#include "host/core/named_views.hpp"

namespace quell {
namespace {

/// Where an image lies in the memory object that it is a part of.
struct Region {
  cl_mem root = nullptr;
  bool whole = false;     ///< an image object: how its texels lie is not known
  std::size_t begin = 0;  ///< bytes
  std::size_t end = 0;
  std::size_t pitch = 0;
  std::size_t rowBytes = 0;
  std::size_t stride = 0;
  std::size_t pixelBytes = 0;
};

template <class Value>
Value infoOf(cl_mem memory, cl_mem_info what) {
  Value value{};
  clGetMemObjectInfo(memory, what, sizeof(value), &value, nullptr);
  return value;
}

Region regionOf(const ImageView& view, Size size) {
  Region region;
  region.root = view.memory;
  std::size_t offset = 0;
  while (cl_mem parent = infoOf<cl_mem>(region.root, CL_MEM_ASSOCIATED_MEMOBJECT)) {
    offset += infoOf<std::size_t>(region.root, CL_MEM_OFFSET);
    region.root = parent;
  }
  region.whole = view.isImageObject();
  if (region.whole) return region;
  region.pitch = static_cast<std::size_t>(std::abs(view.rowPitch(size.width)));
  region.rowBytes = view.rowBytes(size.width);
  region.stride = view.pixelStride();
  region.pixelBytes = view.componentBytes() * static_cast<std::size_t>(view.channels);
  const ByteRange range = rangeOf(view, size);
  region.begin = offset + range.begin;
  region.end = region.begin + range.size;
  return region;
}

/// Whether stretches that begin `distance` apart and repeat with this period leave each other alone.
bool alternate(const Region& a, const Region& b, std::size_t period, std::size_t aBytes, std::size_t bBytes) {
  const std::size_t distance = (b.begin % period + period - a.begin % period) % period;
  return distance >= aBytes && period - distance >= bBytes;
}

bool overlap(const Region& a, const Region& b) {
  if (a.root != b.root) return false;
  if (a.whole || b.whole) return true;
  if (a.end <= b.begin || b.end <= a.begin) return false;
  // Pictures side by side in a larger one, and members of structs, lie between each other.
  if (a.pitch == b.pitch && alternate(a, b, a.pitch, a.rowBytes, b.rowBytes)) return false;
  const bool sameStructs = a.stride == b.stride && a.pitch % a.stride == 0 && b.pitch % b.stride == 0;
  return !(sameStructs && alternate(a, b, a.stride, a.pixelBytes, b.pixelBytes));
}

bool isInPlace(const Frame& frame, const Output& output) {
  const ImageView &radiance = frame.radiance, &linear = output.linear;
  return radiance.memory == linear.memory && radiance.offsetBytes == linear.offsetBytes &&
         sameLayout(radiance, linear, frame.size.width);
}

}  // namespace

void checkOverlaps(const char* function, const Frame& frame, const Output& output) {
  const NamedViews views = namedViews(frame, output);
  std::array<Region, std::tuple_size_v<NamedViews>> regions;
  for (std::size_t i = 0; i < views.size(); ++i)
    if (views[i].view->present()) regions[i] = regionOf(*views[i].view, frame.size);
  for (std::size_t i = 0; i < views.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (!views[i].output || !views[i].view->present() || !views[j].view->present()) continue;
      const bool radianceToLinear =
          views[i].view == &output.linear && views[j].view == &frame.radiance && isInPlace(frame, output);
      if (overlap(regions[i], regions[j]) && !radianceToLinear)
        refuse(function, ErrorCode::InvalidArgument, views[i].name,
               "memory that no other image lies in, or for the linear output the radiance in the same layout",
               "that of " + views[j].name);
    }
  }
}

}  // namespace quell
