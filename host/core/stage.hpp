// A stage: one or a few kernels with one job.
#pragma once

#include <array>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "host/core/bound_kernel.hpp"
#include "host/core/program_cache.hpp"
#include "host/core/program_shelf.hpp"
#include "host/core/schedule.hpp"
#include "kernels/common/frame_image_params.h"
#include "kernels/common/reprojection_params.h"

namespace quell {

class Stage;

/// What a stage builds its kernels with, for one configuration.
class KernelBuilder {
 public:
  explicit KernelBuilder(const Configuration& configuration) : m_configuration(configuration) {}
  virtual ~KernelBuilder() = default;

  const Configuration& configuration() const { return m_configuration; }

  /// The kernel function of the stage's name in kernels/<name>.cl; `defines` as for the compiler, for example
  /// "-D WRITE_PLANES=1". The layouts of the images among the stage's ports are added.
  cl::Kernel build(const Stage& stage, const std::string& defines) const;
  /// The same of a kernel that belongs to no stage and has no images.
  cl::Kernel build(const std::string& stem, const std::string& defines) const;

  /// Largest work-group that device and kernel allow.
  virtual std::size_t maxWorkGroup(const cl::Kernel& kernel) const = 0;

  /// A power of two, `wish` if that is positive, else `usual`; halved until the device allows it.
  std::size_t groupSize(int wish, std::size_t usual) const;

  /// Work-group of a per-pixel kernel: the caller's wish or a good default, reduced to what is allowed.
  cl::NDRange pixelWorkGroup(const cl::Kernel& kernel) const;

 protected:
  /// The options are complete here.
  virtual cl::Kernel compile(const KernelUse& use) const = 0;

 private:
  const Configuration& m_configuration;
};

/// Takes kernels from the shelf, or compiles for a device, or takes from a cache what was compiled before, and puts that on
/// the shelf. All arguments must outlive it.
class DeviceKernelBuilder : public KernelBuilder {
 public:
  DeviceKernelBuilder(const cl::Context& context, const cl::Device& device, const ProgramCache& cache,
                      const Configuration& configuration, ProgramShelf& shelf)
      : KernelBuilder(configuration), m_context(context), m_device(device), m_cache(cache), m_shelf(shelf) {}

  std::size_t maxWorkGroup(const cl::Kernel& kernel) const override;

 protected:
  cl::Kernel compile(const KernelUse& use) const override;

 private:
  SharedProgram share(const ProgramGroup& group) const;
  void buildGroup(const ProgramGroup& group) const;

  const cl::Context& m_context;
  const cl::Device& m_device;
  const ProgramCache& m_cache;
  ProgramShelf& m_shelf;
};

/// The part of a layout that is a kernel argument: in components, or in rows of an image object.
ImageViewParams makeViewParams(const ImageView& view, Size size);
/// Where all images of a frame lie, for kernels.
FrameImageParams makeImageParams(const Frame& frame);
OutputImageParams makeImageParams(const Output& output, Size size);

/// What a stage sees while one frame is enqueued.
class FrameRun {
 public:
  /// `range` is a multiple of `local`.
  using Enqueue =
      std::function<void(const cl::Kernel& kernel, const cl::NDRange& range, const cl::NDRange& local)>;

  /// `arguments`: what the stage's ports are bound to, see BufferSet::arguments().
  FrameRun(const Configuration& c, const Frame& f, const Output& o, const ReprojectionParams& r,
           std::uint32_t index, std::vector<Argument> arguments, Enqueue enqueue)
      : configuration(c),
        frame(f),
        output(o),
        reprojection(r),
        frameIndex(index),
        m_arguments(std::move(arguments)),
        m_enqueue(std::move(enqueue)) {}

  const Configuration& configuration;
  const Frame& frame;
  const Output& output;
  const ReprojectionParams& reprojection;
  const std::uint32_t frameIndex;  ///< frames since the history was reset

  /// Binds the stage's ports and its parameters, the last argument, and enqueues. `global` is rounded up to a multiple
  /// of `local`.
  template <class Params>
  void launch(BoundKernel& kernel, std::array<std::size_t, 2> global, const cl::NDRange& local,
              const Params& params) const {
    kernel.bind(m_arguments, &params, sizeof(Params));
    enqueueRounded(kernel, global, local);
  }

  /// The usual range of a per-pixel kernel: QUELL_LANES pixels of a row a work-item.
  std::array<std::size_t, 2> pixelRange() const { return pixelItems(configuration); }

 private:
  void enqueueRounded(const cl::Kernel& kernel, std::array<std::size_t, 2> global,
                      const cl::NDRange& local) const;

  std::vector<Argument> m_arguments;
  Enqueue m_enqueue;
};

/// What a stage that has the port `surfaces` works on.
enum class Coverage {
  Everything,
  Surfaces,
  AroundSurfaces,  ///< and the background next to them
  Background,
};

class Stage {
 public:
  virtual ~Stage() = default;
  /// The stem: names the kernel file, this class's file, the oracle, the test and the bench entry.
  virtual std::string name() const = 0;
  /// The name, with what tells this stage from others of that name in a method; for reports.
  virtual std::string label() const { return name(); }
  /// What it reads and writes, in the order of the kernel's arguments.
  virtual std::vector<Port> ports(const Configuration& configuration, const Content& content = {}) const = 0;
  /// Which pixels of this frame it works on where it knows the surfaces.
  virtual Coverage coverage(const Frame&) const { return Coverage::Surfaces; }
  /// Compiles the stage's kernels.
  virtual void build(const KernelBuilder& builder) = 0;
  /// Enqueues the stage's kernels for one frame.
  virtual void enqueue(FrameRun& run) = 0;
};

/// Whether it is less than everything because background is left out, if not all of it.
bool leavesOutBackground(Coverage coverage);
/// Share of a frame of this content, 0 to 1.
double coveredShare(Coverage coverage, const Content& content);

/// What the stage works on: everything, unless it reads the buffer of surfaces.
Coverage coverageOf(const Stage& stage, const Configuration& configuration);

/// Bytes that a frame of this content makes the stage touch, each counted once (twice where it is updated).
std::uint64_t stageBytes(const Stage& stage, const Configuration& configuration, const Content& content = {});

/// A stage of one kernel whose work-items take QUELL_LANES pixels each, unless range() says otherwise. `Interface` comes
/// from QUELL_OPTIONS, `Params` is the kernel's last argument.
template <class Interface, class Params>
class KernelStage : public Stage, protected Interface {
 public:
  std::string name() const final { return Interface::kStem; }
  std::vector<Port> ports(const Configuration& configuration, const Content& content = {}) const final {
    return Interface::makePorts(configuration, content);
  }
  void build(const KernelBuilder& builder) override {
    m_kernel = builder.build(*this, Interface::defines() + textDefines());
    m_workGroup = builder.pixelWorkGroup(m_kernel);
  }
  void enqueue(FrameRun& run) final { run.launch(m_kernel, range(run), m_workGroup, params(run)); }

 protected:
  virtual Params params(const FrameRun& run) const = 0;
  virtual std::array<std::size_t, 2> range(const FrameRun& run) const { return run.pixelRange(); }
  /// Compile options that are no numbers.
  virtual std::string textDefines() const { return {}; }

  BoundKernel m_kernel;
  cl::NDRange m_workGroup;
};

}  // namespace quell
