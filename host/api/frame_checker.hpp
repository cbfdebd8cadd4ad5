// Frames in device buffers, checked on the host.
#pragma once

#include <memory>
#include <quell/check.hpp>
#include <quell/frame.hpp>
#include <vector>

#include "host/core/opencl.hpp"

namespace quell {

struct HostFrame;

/// Keeps the frame that was checked last, to compare the next with.
class FrameChecker {
 public:
  FrameChecker();
  ~FrameChecker();

  /// Reads the images, whose layouts and memory are in order, and blocks.
  FrameCheck check(const cl::CommandQueue& queue, const Frame& frame, const std::vector<cl::Event>& waitFor);
  /// The next frame does not follow the last.
  void forget();

 private:
  std::unique_ptr<HostFrame> m_last;
};

}  // namespace quell
