#include "host/core/warm_up.hpp"

#include "host/core/image_schema.hpp"

namespace quell {

WarmUpImages::WarmUpImages(const cl::Context& context, const cl::CommandQueue& queue, const Frame& layout,
                           const Output& outputLayout)
    : frame(layout), output(outputLayout) {
  for (const auto& image : kInputs<Frame>) provide(context, queue, frame.*image.member);
  for (const auto& image : kOutputs<Output>) provide(context, queue, output.*image.member);
  // Any camera will do; this one looks along -z.
  frame.camera.worldToClip = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, -1, 0, 0, -1, 0};
  frame.camera.worldToClipPrev = frame.camera.worldToClip;
}

void WarmUpImages::provide(const cl::Context& context, const cl::CommandQueue& queue, ImageView& view) {
  if (!view.present()) return;
  if (view.isImageObject()) {
    // The format does not matter to kernels.
    m_images.emplace_back(context, CL_MEM_READ_WRITE, cl::ImageFormat(CL_RGBA, CL_FLOAT),
                          static_cast<std::size_t>(frame.size.width),
                          static_cast<std::size_t>(frame.size.height));
    queue.enqueueFillImage(
        m_images.back(), cl_float4{}, {0, 0, 0},
        {static_cast<std::size_t>(frame.size.width), static_cast<std::size_t>(frame.size.height), 1});
    view.memory = m_images.back()();
    return;
  }
  const std::size_t bytes = view.requiredBytes(frame.size);
  m_buffers.emplace_back(context, CL_MEM_READ_WRITE, bytes);
  queue.enqueueFillBuffer(m_buffers.back(), cl_uchar(0), 0, bytes);
  view.memory = m_buffers.back()();
}

}  // namespace quell
