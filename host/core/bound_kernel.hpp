// A kernel with its arguments, of which those that stay the same from frame to frame are set once.
#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "host/core/opencl.hpp"

namespace quell {

/// What a port is bound to.
struct Argument {
  cl_mem memory = nullptr;  ///< null: no buffer
  /// The runtime's own, which lives as long as the kernel. The caller's memory may go, and other memory come at the same
  /// address, which drivers need not notice: it is set for every launch.
  bool own = false;
};

class BoundKernel {
 public:
  BoundKernel() = default;
  BoundKernel(cl::Kernel kernel) : m_kernel(std::move(kernel)) {}  // NOLINT: it is a kernel

  operator const cl::Kernel&() const { return m_kernel; }  // NOLINT

  /// Sets what has changed: the memory of the first arguments, and behind it `size` bytes of parameters.
  void bind(const std::vector<Argument>& arguments, const void* params, std::size_t size);

 private:
  cl::Kernel m_kernel;
  std::vector<std::optional<cl_mem>> m_bound;  // per argument; none: to be set
  std::vector<unsigned char> m_params;
};

}  // namespace quell
