#include "host/core/render_rectangle.hpp"

#include "host/core/image_schema.hpp"

namespace quell {
namespace {

void fixRowPitch(ImageView& view, Size size) {
  if (view.present() && !view.isImageObject()) view.rowPitchBytes = view.rowPitch(size.width);
}

}  // namespace

Frame renderedPart(const Frame& frame) {
  Frame part = frame;
  if (!hasRenderSize(frame)) return part;
  for (const auto& image : kInputs<Frame>) fixRowPitch(part.*image.member, frame.size);
  part.size = frame.renderSize;
  return part;
}

Output renderedPart(const Output& output, const Frame& frame) {
  Output part = output;
  if (!hasRenderSize(frame)) return part;
  for (const auto& image : kOutputs<Output>) fixRowPitch(part.*image.member, frame.size);
  return part;
}

}  // namespace quell
