// Images of a caller in host memory, as stages would read them.
#pragma once

#include <quell/frame.hpp>
#include <vector>

#include "host/core/opencl.hpp"

namespace quell {

struct HostImage {
  std::vector<float> values;  ///< row by row from the top, interleaved
  int channels = 0;
};

/// Reads an image of the frame that is present, whose layout and memory are in order, and blocks: sums are divided, depth is
/// view depth, motion is in pixels.
HostImage readImage(const cl::CommandQueue& queue, const Frame& frame, const ImageView Frame::*input,
                    const std::vector<cl::Event>& waitFor);

}  // namespace quell
