#include "host/core/ports.hpp"

#include <algorithm>

#include "host/core/imported_images.hpp"
#include "host/core/schedule.hpp"

namespace quell {
namespace {

constexpr char kPreviousEnding[] = "Prev";

/// Components of a pixel that kernels load: packed pixels as a whole, of others what is used (common/image_access.h).
std::size_t loadedChannels(const ImageView& view) {
  const bool packed = view.pixelStride() == view.componentBytes() * static_cast<std::size_t>(view.channels);
  return static_cast<std::size_t>(packed ? view.channels : std::min(view.channels, 3));
}

double imageBytes(const ImageView& view, Size size) {
  const std::size_t pixel =
      view.isImageObject() ? texelBytes(view) : loadedChannels(view) * view.componentBytes();
  return static_cast<double>(size.width) * static_cast<double>(size.height) *
         static_cast<double>(view.present() ? pixel : 0);
}

}  // namespace

std::size_t elementBytes(Element element) {
  switch (element) {
    case Element::UInt8:
      return 1;
    case Element::Float16:
      return 2;
    case Element::Float32x4:
      return 16;
    case Element::Float32:
    case Element::Int32:
      break;
  }
  return 4;
}

const char* toString(Element element) {
  switch (element) {
    case Element::Float32:
      return "float";
    case Element::Float16:
      return "half";
    case Element::UInt8:
      return "uchar";
    case Element::Int32:
      return "int";
    case Element::Float32x4:
      break;
  }
  return "float4";
}

bool operator==(const Extent& a, const Extent& b) {
  return a.planes == b.planes && (a.planes != 0 || a.elements == b.elements);
}

std::string toString(const Extent& extent) {
  return extent.planes != 0 ? std::to_string(extent.planes) + " planes"
                            : std::to_string(extent.elements) + " elements";
}

std::string Port::usualBuffer() const {
  std::string buffer = name;
  const std::size_t ending = sizeof(kPreviousEnding) - 1;
  if (access == Access::Previous && buffer.size() > ending &&
      buffer.compare(buffer.size() - ending, ending, kPreviousEnding) == 0)
    buffer.resize(buffer.size() - ending);
  return buffer;
}

ImageView Port::view(const Frame& frame, const Output& out) const {
  if (!exists || !isImage()) return {};
  if (output != nullptr) return out.*output;
  return asGiven ? frame.*input : viewForStages(frame, input);
}

double touchedBytes(const Port& port, const Configuration& configuration) {
  if (!port.exists) return 0.0;
  const Size size = configuration.size();
  if (port.isImage())
    return port.touched * imageBytes(port.view(configuration.frame, configuration.output), size);
  const double elements = port.extent.planes == 0
                              ? static_cast<double>(port.extent.elements)
                              : static_cast<double>(size.width) * static_cast<double>(size.height) *
                                    static_cast<double>(port.extent.planes);
  return port.touched * elements * static_cast<double>(elementBytes(port.element)) *
         (port.access == Access::Update || port.access == Access::Scratch ? 2.0 : 1.0);
}

}  // namespace quell
