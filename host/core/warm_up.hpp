// Stand-ins for the caller's images while kernels are launched for the first time.
#pragma once

#include <quell/frame.hpp>
#include <vector>

#include "host/core/opencl.hpp"

namespace quell {

class WarmUpImages {
 public:
  /// Images of zeros in these layouts.
  WarmUpImages(const cl::Context& context, const cl::CommandQueue& queue, const Frame& layout,
               const Output& outputLayout);

  Frame frame;
  Output output;

 private:
  void provide(const cl::Context& context, const cl::CommandQueue& queue, ImageView& view);

  std::vector<cl::Buffer> m_buffers;
  std::vector<cl::Image2D> m_images;
};

}  // namespace quell
