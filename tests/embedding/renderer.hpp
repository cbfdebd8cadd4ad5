// A renderer in small: its own context, buffers in its own layouts, a kernel that fills them. Raw OpenCL throughout.
#pragma once

#include <CL/cl.h>

#include <cstddef>
#include <quell/quell.hpp>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace embedding {

/// Throws std::runtime_error unless an OpenCL call succeeded.
inline void check(cl_int code, const char* call) {
  if (code != CL_SUCCESS)
    throw std::runtime_error(std::string(call) + ": OpenCL error " + std::to_string(code));
}

/// Owns one reference to an OpenCL object.
template <class Object, cl_int (*release)(Object)>
class Handle {
 public:
  Handle() = default;
  explicit Handle(Object object) : m_object(object) {}
  Handle(Handle&& other) noexcept : m_object(std::exchange(other.m_object, nullptr)) {}
  Handle& operator=(Handle&& other) noexcept {
    std::swap(m_object, other.m_object);
    return *this;
  }
  ~Handle() {
    if (m_object != nullptr) release(m_object);
  }
  Object get() const { return m_object; }

 private:
  Object m_object = nullptr;
};
using Context = Handle<cl_context, clReleaseContext>;
using Queue = Handle<cl_command_queue, clReleaseCommandQueue>;
using Program = Handle<cl_program, clReleaseProgram>;
using Kernel = Handle<cl_kernel, clReleaseKernel>;
using Buffer = Handle<cl_mem, clReleaseMemObject>;
using Event = Handle<cl_event, clReleaseEvent>;

/// The device that QUELL_TEST_DEVICE names, by default the preferred one, with a context of the renderer's own.
struct Device {
  Device();
  Queue makeQueue(cl_command_queue_properties properties) const;

  cl_device_id id = nullptr;
  Context context;
};

/// Both outputs of a frame.
struct Picture {
  std::vector<float> linear;
  std::vector<float> display;
};
inline bool operator==(const Picture& a, const Picture& b) {
  return a.linear == b.linear && a.display == b.display;
}

/// A camera that drives along a wall on a floor.
class Renderer {
 public:
  /// `queue` must outlive the renderer.
  Renderer(const Device& device, const Queue& queue);

  /// Enqueues the tracing of frame `number` once `waitFor` has completed.
  Event trace(int number, const std::vector<cl_event>& waitFor);
  /// What the denoiser is told about frame `number`.
  quell::Frame frame(int number) const;
  quell::Output output() const;
  /// Enqueues reading both outputs once `waitFor` has completed; `picture` must live until the event has.
  Event read(Picture& picture, cl_event waitFor);

 private:
  cl_command_queue m_queue;
  Program m_program;
  Kernel m_trace;
  Buffer m_radiance;  ///< float4
  Buffer m_surfaces;  ///< structs of normal, position and albedo
  Buffer m_linear;    ///< packed float3
  Buffer m_display;   ///< float4
};

}  // namespace embedding
