// A method that is ready to run: its stages compiled, its buffers allocated, all names resolved.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "host/core/buffer_set.hpp"
#include "host/core/disk_cache.hpp"
#include "host/core/frame_commands.hpp"
#include "host/core/history_resampler.hpp"
#include "host/core/schedule.hpp"
#include "host/core/stage.hpp"
#include "host/core/tuning.hpp"

namespace quell {

class Pipeline {
 public:
  Pipeline() = default;
  using MakeSchedule = std::function<Schedule(const Configuration&)>;
  /// Called with the label of a stage that is built or has run first, the steps that are done, and all there are (two a
  /// stage); what it throws ends the work.
  using Progress = std::function<void(const std::string& stage, int done, int total)>;

  /// Compiles what `held` lacks and allocates; blocks. What was measured on the device decides on pixels per work-item. Throws
  /// Error(InvalidArgument) for an unknown name among Options::keptBuffers, Error(BuildFailed), Error(OutOfMemory), and
  /// std::logic_error as makePlan().
  Pipeline(const cl::Context& context, const cl::Device& device, const cl::CommandQueue& queue,
           const ProgramCache& cache, Configuration configuration, const MakeSchedule& makeSchedule,
           ProgramShelf held = {}, const Progress& progress = {});

  /// Runs every stage once on stand-ins, since machine code is often made at the first launch; blocks. The last event, and
  /// histories that hold what came of it.
  cl::Event warmUp(const cl::Context& context, const cl::CommandQueue& queue, const Progress& progress = {});

  /// Where the kernels of each stage would come from.
  static std::vector<StageKernel> kernelStates(const Pipeline& built, const ProgramCache& cache,
                                               Configuration configuration, const MakeSchedule& makeSchedule);

  /// Whether what is compiled and allocated serves these settings as well; only settings and what follows from them may
  /// differ in `configuration`. Throws as makeSchedule.
  bool serves(const Configuration& configuration, const MakeSchedule& makeSchedule) const;
  /// Takes the settings of a configuration that it serves. Compiles and allocates nothing.
  void retune(const Configuration& configuration, const MakeSchedule& makeSchedule,
              const cl::Context& context, const cl::Device& device, const ProgramCache& cache);

  /// The programs that its kernels are from.
  const ProgramShelf& programs() const { return m_programs; }

  /// What such a pipeline would allocate. Throws as above, but builds nothing.
  static MemoryUse memoryNeeded(const ProgramCache& cache, Configuration configuration,
                                const MakeSchedule& makeSchedule);

  const Configuration& configuration() const { return m_configuration; }
  const Plan& plan() const { return m_plan; }
  const BufferSet& buffers() const { return m_buffers; }

  /// Pixels that the latest frame rendered, up to the prepared size, and the configuration with that size.
  Size renderSize() const { return m_renderSize; }
  Configuration renderedConfiguration() const;
  /// Takes frames of another size from now on. Allocates and compiles nothing.
  void setRenderSize(Size size);
  /// The same with the histories that the frame before `frameIndex` has left, which are resampled; the configuration has a
  /// render size.
  void resampleHistories(FrameCommands& commands, Size size, std::uint32_t frameIndex);

  /// Enqueues all stages of a frame, whose size is renderSize().
  void record(FrameCommands& commands, const Frame& frame, const Output& output,
              const ReprojectionParams& reprojection, std::uint32_t frameIndex) const;

  /// Names, labels and bytes of the stages, in their order.
  std::vector<std::string> stageNames() const;
  std::vector<std::string> stageLabels() const;
  std::vector<std::uint64_t> stageBytes(const Frame& frame, const Content& content) const;

  /// Whether some stages leave out background; then surfaces() says where it was in the latest frame. What each stage
  /// works on depends on the frame.
  bool leavesOutBackground() const;
  std::vector<Coverage> coverages(const Frame& frame) const;
  /// Reads, on a queue of the same device, which work-items showed a surface: 1, else 0. Blocks.
  std::vector<std::uint8_t> surfaces(const cl::CommandQueue& queue) const;

 private:
  void plan(const DeviceTuning& tuning, const MakeSchedule& makeSchedule);
  void recordStage(std::size_t index, FrameCommands& commands, const Frame& frame, const Output& output,
                   const ReprojectionParams& reprojection, std::uint32_t frameIndex) const;
  void agreeOnLanes(const DeviceTuning& tuning, const MakeSchedule& makeSchedule);
  void buildStages(const cl::Context& context, const cl::Device& device, const ProgramCache& cache,
                   const Progress& progress);
  void tuneStages(const DeviceTuning& tuning);
  /// What the stages, one after the other, and the resampler compile. The stages cannot run until they are built again.
  std::vector<std::vector<KernelUse>> neededKernels() const;

  Configuration m_configuration;
  Size m_renderSize;
  Schedule m_schedule;
  Plan m_plan;
  std::vector<Configuration> m_stageConfigurations;  // as m_configuration, but tuned
  ProgramShelf m_programs;
  BufferSet m_buffers;
  HistoryResampler m_resampler;  // built where the configuration has a render size
};

}  // namespace quell
