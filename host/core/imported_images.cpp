#include "host/core/imported_images.hpp"

#include <algorithm>

#include "host/core/stage.hpp"

namespace quell {
namespace {

constexpr std::size_t kMostTexelBytes = 4 * sizeof(float);
constexpr int kMostChannels = 3;  // that stages look at

}  // namespace

bool isImported(const Frame& frame, const ImageView Frame::*input) {
  const ImageView& view = frame.*input;
  const bool otherDepth = input == &Frame::viewDepth && frame.depthKind != DepthKind::View;
  return view.present() && (view.isImageObject() || view.sum != Sum::None || otherDepth);
}

ImageView viewForStages(const Frame& frame, const ImageView Frame::*input) {
  const ImageView& view = frame.*input;
  return isImported(frame, input) ? packedImage(nullptr, std::min(view.channels, kMostChannels)) : view;
}

std::string importedBuffer(const char* image) { return std::string(image) + "Imported"; }

Extent importedExtent(const Frame& frame, const ImageView Frame::*input) {
  return Extent::records(viewForStages(frame, input).requiredBytes(frame.size) / sizeof(float));
}

bool readsImage(const Schedule& table, const Configuration& configuration, const ImageView Frame::*input) {
  return std::any_of(table.begin(), table.end(), [&](const StageRow& row) {
    const std::vector<Port> ports = row.stage->ports(configuration);
    return std::any_of(ports.begin(), ports.end(),
                       [&](const Port& port) { return port.exists && port.input == input; });
  });
}

std::size_t texelBytes(const ImageView& view) {
  return view.pixelStrideBytes != 0 ? view.pixelStrideBytes : kMostTexelBytes;
}

}  // namespace quell
