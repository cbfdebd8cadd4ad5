// A stage: one or a few kernels with one job.
#pragma once

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "host/core/program_cache.hpp"
#include "host/core/schedule.hpp"
#include "kernels/common/reprojection_params.h"

namespace quell {

/// What a stage builds its kernels with, for one configuration.
class KernelBuilder {
 public:
  explicit KernelBuilder(const Configuration& configuration) : m_configuration(configuration) {}
  virtual ~KernelBuilder() = default;

  const Configuration& configuration() const { return m_configuration; }

  /// The kernel function `stem` of kernels/<stem>.cl; `options` as for the compiler, for example "-D
  /// WRITE_PLANES=1".
  cl::Kernel build(const std::string& stem, const std::string& options) const;

  /// Largest work-group that device and kernel allow.
  virtual std::size_t maxWorkGroup(const cl::Kernel& kernel) const = 0;

  /// A power of two, `wish` if that is positive, else `usual`; halved until the device allows it.
  std::size_t groupSize(int wish, std::size_t usual) const;

  /// Work-group of a per-pixel kernel: the caller's wish or a good default, reduced to what is allowed.
  cl::NDRange pixelWorkGroup(const cl::Kernel& kernel) const;

 protected:
  /// `options` are complete here.
  virtual cl::Kernel compile(const std::string& stem, const std::string& options) const = 0;

 private:
  const Configuration& m_configuration;
};

/// Compiles for a device, or takes from a cache what was compiled before. All arguments must outlive it.
class DeviceKernelBuilder : public KernelBuilder {
 public:
  DeviceKernelBuilder(const cl::Context& context, const cl::Device& device, const ProgramCache& cache,
                      const Configuration& configuration)
      : KernelBuilder(configuration), m_context(context), m_device(device), m_cache(cache) {}

  std::size_t maxWorkGroup(const cl::Kernel& kernel) const override;

 protected:
  cl::Kernel compile(const std::string& stem, const std::string& options) const override;

 private:
  const cl::Context& m_context;
  const cl::Device& m_device;
  const ProgramCache& m_cache;
};

/// Compile options that describe the layout of a caller's image: NAME_FORMAT, NAME_CHANNELS, NAME_STRIDE.
std::string layoutOptions(const std::string& name, const ImageView& view);
/// The part of the layout that is a kernel argument.
ImageViewParams makeViewParams(const ImageView& view, Size size);
/// Bytes of a caller's image that a stage touches; 0 for an absent one.
std::uint64_t imageBytes(const ImageView& view, Size size);

/// Compile option of a kernel that leaves out what the frame does not need; see kernels/common/surfaces.h.
inline std::string skipOption(bool skip) { return skip ? " -D SKIP=1" : " -D SKIP=0"; }

/// What a stage sees while one frame is enqueued.
class FrameRun {
 public:
  virtual ~FrameRun() = default;

  const Configuration& configuration;
  const Frame& frame;
  const Output& output;
  const ReprojectionParams& reprojection;
  const std::uint32_t frameIndex;  ///< frames since the history was reset

  /// Buffers that the stage's line of the table names; "<name>.prev" for the frame before.
  virtual const cl::Buffer& buffer(const std::string& name) const = 0;

  /// Sets all arguments in order and enqueues. `global` is rounded up to a multiple of `local`.
  template <class... Arguments>
  void launch(cl::Kernel& kernel, std::array<std::size_t, 2> global, const cl::NDRange& local,
              const Arguments&... arguments) {
    cl_uint index = 0;
    (setArgument(kernel, index++, arguments), ...);
    enqueue(kernel, global, local);
  }

  /// The usual range of a per-pixel kernel: QUELL_LANES pixels of a row a work-item.
  std::array<std::size_t, 2> pixelRange() const;

 protected:
  FrameRun(const Configuration& c, const Frame& f, const Output& o, const ReprojectionParams& r,
           std::uint32_t index)
      : configuration(c), frame(f), output(o), reprojection(r), frameIndex(index) {}
  virtual void enqueue(const cl::Kernel& kernel, std::array<std::size_t, 2> global,
                       const cl::NDRange& local) = 0;

 private:
  static void setArgument(cl::Kernel& kernel, cl_uint index, const ImageView& view) {
    const cl_mem memory = view.present() ? view.memory : nullptr;
    kernel.setArg(index, sizeof(cl_mem), &memory);
  }
  static void setArgument(cl::Kernel& kernel, cl_uint index, const cl::Buffer& buffer) {
    kernel.setArg(index, buffer);
  }
  template <class Value>
  static void setArgument(cl::Kernel& kernel, cl_uint index, const Value& value) {
    kernel.setArg(index, sizeof(Value), &value);
  }
};

class Stage {
 public:
  virtual ~Stage() = default;
  /// The stem: names the kernel file, this class's file, the oracle, the test and the bench entry.
  virtual std::string name() const = 0;
  /// The name, with what tells this stage from others of that name in a method; for reports.
  virtual std::string label() const { return name(); }
  /// Compiles the stage's kernels.
  virtual void build(const KernelBuilder& builder) = 0;
  /// Enqueues the stage's kernels for one frame.
  virtual void enqueue(FrameRun& run) = 0;
  /// Bytes of the caller's images that the stage reads and writes per frame; buffers are known from the
  /// table.
  virtual std::uint64_t callerBytes(const Configuration& configuration) const = 0;
};

}  // namespace quell
