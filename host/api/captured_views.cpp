#include "host/api/captured_views.hpp"

#include <algorithm>

#include "host/core/fnv1a.hpp"
#include "host/core/named_views.hpp"
#include "host/core/render_rectangle.hpp"

namespace quell {
namespace {

// Offsets in a buffer keep what they are beyond multiples of this, so that alignment is that of the original.
constexpr std::uint64_t kAlignment = 4096;  // bytes
constexpr char kOutputPrefix[] = "output.";

template <class Value>
Value imageInfo(cl_mem image, cl_image_info what) {
  Value value{};
  clGetImageInfo(image, what, sizeof(value), &value, nullptr);
  return value;
}

CapturedMemory describeImage(cl_mem image, Size size) {
  CapturedMemory memory;
  const auto format = imageInfo<cl_image_format>(image, CL_IMAGE_FORMAT);
  memory.isImage = true;
  memory.order = format.image_channel_order;
  memory.type = format.image_channel_data_type;
  // An image may be larger than the frame, which lies in its corner.
  memory.width = static_cast<std::uint64_t>(size.width);
  memory.height = static_cast<std::uint64_t>(size.height);
  memory.size = memory.width * memory.height * imageInfo<std::size_t>(image, CL_IMAGE_ELEMENT_SIZE);
  return memory;
}

/// Makes the range of the buffer that is captured cover a further one.
void extend(CapturedMemory& memory, const ByteRange& range) {
  const std::uint64_t begin = range.begin / kAlignment * kAlignment;
  const std::uint64_t end = std::max(memory.base + memory.size, std::uint64_t{range.begin} + range.size);
  memory.base = memory.size == 0 ? begin : std::min(memory.base, begin);
  memory.size = (memory.size == 0 ? range.begin + range.size : end) - memory.base;
}

}  // namespace

bool isOutput(const CapturedView& view) { return view.name.rfind(kOutputPrefix, 0) == 0; }

ByteRange rangeOf(const CapturedView& view, const CapturedFrame& captured) {
  const CapturedMemory& memory = captured.memories[static_cast<std::size_t>(view.memory)];
  return memory.isImage ? ByteRange{0, memory.size} : rangeOf(view.view, renderedSize(captured.frame));
}

std::vector<cl_mem> captureViews(const Frame& frame, const Output& output, CapturedFrame& captured) {
  std::vector<cl_mem> handles;
  for (const NamedView& named : namedViews(frame, output)) {
    const ImageView& view = *named.view;
    if (!view.present()) continue;
    const auto found = std::find(handles.begin(), handles.end(), view.memory);
    const auto index = static_cast<std::size_t>(found - handles.begin());
    if (found == handles.end()) {
      handles.push_back(view.memory);
      captured.memories.push_back(view.isImageObject() ? describeImage(view.memory, frame.size)
                                                       : CapturedMemory());
    }
    if (!view.isImageObject()) extend(captured.memories[index], rangeOf(view, frame.size));
    captured.views.push_back({named.name, static_cast<int>(index), view});
  }
  return handles;
}

bool readsFrom(const CapturedFrame& captured, int memory) {
  return std::any_of(captured.views.begin(), captured.views.end(),
                     [memory](const CapturedView& view) { return view.memory == memory && !isOutput(view); });
}

std::uint64_t pixelHash(const CapturedView& captured, const CapturedFrame& frame, const Bytes& bytes) {
  std::uint64_t hash = kFnv1aStart;
  const ImageView& view = captured.view;
  const Size size = renderedSize(frame.frame);
  if (view.isImageObject()) return fnv1a(bytes.data(), bytes.size(), hash);
  const std::ptrdiff_t pitch = view.rowPitch(size.width);
  const unsigned char* top = bytes.data() + (pitch < 0 ? std::ptrdiff_t{size.height - 1} * -pitch : 0);
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x)
      hash = fnv1a(top + std::ptrdiff_t{y} * pitch +
                       std::ptrdiff_t{x} * static_cast<std::ptrdiff_t>(view.pixelStride()),
                   view.componentBytes() * static_cast<std::size_t>(view.channels), hash);
  return hash;
}

}  // namespace quell
