#include "host/core/pipeline.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "host/core/kernel_uses.hpp"
#include "host/core/render_rectangle.hpp"
#include "host/core/reprojection.hpp"
#include "host/core/warm_up.hpp"

namespace quell {
namespace {

/// Whether the row touches the buffer that says where surfaces are.
bool touches(const std::vector<Binding>& row, int buffer) {
  return std::any_of(row.begin(), row.end(),
                     [&](const Binding& binding) { return binding.hasBuffer() && binding.buffer == buffer; });
}

std::vector<KernelUse> joined(const std::vector<std::vector<KernelUse>>& lists) {
  std::vector<KernelUse> all;
  for (const auto& list : lists) all.insert(all.end(), list.begin(), list.end());
  return all;
}

}  // namespace

Pipeline::Pipeline(const cl::Context& context, const cl::Device& device, const cl::CommandQueue& queue,
                   const ProgramCache& cache, Configuration configuration, const MakeSchedule& makeSchedule,
                   ProgramShelf held, const Progress& progress)
    : m_configuration(std::move(configuration)),
      m_renderSize(m_configuration.size()),
      m_programs(std::move(held)) {
  const DeviceTuning tuning = readTuning(cache.disk(), m_configuration.device.identity);
  plan(tuning, makeSchedule);
  tuneStages(tuning);
  m_programs.expect(joined(neededKernels()));
  buildStages(context, device, cache, progress);
  if (hasRenderSize(m_configuration.frame))
    m_resampler.build(DeviceKernelBuilder(context, device, cache, m_configuration, m_programs), m_plan);
  m_buffers = BufferSet(context, queue, m_plan, m_configuration.size(), m_configuration.options.keptBuffers);
}

MemoryUse Pipeline::memoryNeeded(const ProgramCache& cache, Configuration configuration,
                                 const MakeSchedule& makeSchedule) {
  Pipeline planned;
  planned.m_configuration = std::move(configuration);
  planned.plan(readTuning(cache.disk(), planned.m_configuration.device.identity), makeSchedule);
  return BufferSet(planned.m_plan, planned.m_configuration.size(),
                   planned.m_configuration.options.keptBuffers)
      .memoryUse();
}

void Pipeline::plan(const DeviceTuning& tuning, const MakeSchedule& makeSchedule) {
  agreeOnLanes(tuning, makeSchedule);
  for (const std::string& name : m_configuration.options.keptBuffers)
    m_plan.require(name, "prepare", "options.keptBuffers");
}

// The surfaces have one byte a work-item: stages that share them must agree on what a work-item is.
void Pipeline::agreeOnLanes(const DeviceTuning& tuning, const MakeSchedule& makeSchedule) {
  const auto plan = [&] {
    m_schedule = makeSchedule(m_configuration);
    m_plan = makePlan(m_schedule, m_configuration);
  };
  plan();
  std::vector<std::string> sharing;
  for (std::size_t i = 0; i < m_schedule.size(); ++i)
    if (touches(m_plan.rows[i], m_plan.find(kSurfacesBuffer))) sharing.push_back(m_schedule[i].stage->name());
  const int lanes = commonLanes(tuning, sharing, m_configuration);
  if (lanes == m_configuration.device.lanes) return;
  m_configuration.device.lanes = lanes;
  plan();
}

void Pipeline::tuneStages(const DeviceTuning& tuning) {
  const int surfaces = m_plan.find(kSurfacesBuffer);
  m_stageConfigurations.clear();
  for (std::size_t i = 0; i < m_schedule.size(); ++i) {
    Configuration tuned = m_configuration;
    applyTuning(tuning, m_schedule[i].stage->name(), tuned);
    if (touches(m_plan.rows[i], surfaces) && tuned.device.lanes != m_configuration.device.lanes)
      tuned = m_configuration;
    m_stageConfigurations.push_back(std::move(tuned));
  }
}

std::vector<std::vector<KernelUse>> Pipeline::neededKernels() const {
  std::vector<std::vector<KernelUse>> needed;
  for (std::size_t i = 0; i < m_schedule.size(); ++i)
    needed.push_back(kernelUses(*m_schedule[i].stage, m_stageConfigurations[i]));
  if (hasRenderSize(m_configuration.frame))
    needed.push_back(kernelUses(
        [&](const KernelBuilder& builder) { HistoryResampler().build(builder, m_plan); }, m_configuration));
  return needed;
}

// One after the other: PoCL 3.1 holds a lock of the context while it compiles, so that threads gain nothing
// (docs/embedding.md, "Cold start").
void Pipeline::buildStages(const cl::Context& context, const cl::Device& device, const ProgramCache& cache,
                           const Progress& progress) {
  for (std::size_t i = 0; i < m_schedule.size(); ++i) {
    m_schedule[i].stage->build(
        DeviceKernelBuilder(context, device, cache, m_stageConfigurations[i], m_programs));
    if (progress)
      progress(m_schedule[i].stage->label(), static_cast<int>(i + 1),
               static_cast<int>(2 * m_schedule.size()));
  }
}

cl::Event Pipeline::warmUp(const cl::Context& context, const cl::CommandQueue& queue,
                           const Progress& progress) {
  const WarmUpImages images(context, queue, m_configuration.frame, m_configuration.output);
  const ReprojectionParams reprojection =
      makeReprojectionParams(images.frame.camera, images.frame.size, m_configuration.runtime.discard, false,
                             images.frame.motionScale);
  cl::Event last;
  const std::size_t count = m_schedule.size();
  for (std::size_t i = 0; i < count; ++i) {
    FrameCommands commands(queue, {}, true, false);
    recordStage(i, commands, images.frame, images.output, reprojection, 0);
    queue.finish();  // also where the queue is out of order
    last = commands.lastEvent();
    if (progress)
      progress(m_schedule[i].stage->label(), static_cast<int>(count + i + 1), static_cast<int>(2 * count));
  }
  if (hasRenderSize(m_configuration.frame)) {
    FrameCommands commands(queue, {}, true, false);
    m_resampler.enqueue(commands, m_plan, m_buffers, 0, m_renderSize, m_renderSize);
    queue.finish();
  }
  return last;
}

std::vector<StageKernel> Pipeline::kernelStates(const Pipeline& built, const ProgramCache& cache,
                                                Configuration configuration,
                                                const MakeSchedule& makeSchedule) {
  Pipeline planned;
  planned.m_configuration = std::move(configuration);
  const DeviceTuning tuning = readTuning(cache.disk(), planned.m_configuration.device.identity);
  planned.plan(tuning, makeSchedule);
  planned.tuneStages(tuning);
  const std::vector<std::vector<KernelUse>> needed = planned.neededKernels();
  ProgramShelf shelf = built.m_programs;
  shelf.expect(joined(needed));
  std::map<KernelUse, KernelState> compiled;  // of those that are not built
  const auto stateOf = [&](const KernelUse& use) {
    if (shelf.find(use)) return KernelState::Built;
    if (const auto known = compiled.find(use); known != compiled.end()) return known->second;
    const ProgramGroup group = shelf.groupOf(use);
    const bool cached = cache.has(planned.m_configuration.device, group.source(), group.options());
    const KernelState state = cached ? KernelState::Cached : KernelState::Missing;
    for (const KernelUse& member : group.kernels) compiled[member] = state;
    return state;
  };
  std::vector<StageKernel> kernels;
  for (std::size_t i = 0; i < needed.size(); ++i) {
    const bool isStage = i < planned.m_schedule.size();
    StageKernel kernel{isStage ? planned.m_schedule[i].stage->label() : HistoryResampler::kStem,
                       KernelState::Built};
    for (const KernelUse& use : needed[i]) kernel.state = std::min(kernel.state, stateOf(use));
    kernels.push_back(std::move(kernel));
  }
  return kernels;
}

Configuration Pipeline::renderedConfiguration() const {
  Configuration rendered = m_configuration;
  rendered.frame.size = m_renderSize;
  return rendered;
}

void Pipeline::setRenderSize(Size size) {
  m_renderSize = size;
  for (Configuration& tuned : m_stageConfigurations) tuned.frame.size = size;
}

void Pipeline::resampleHistories(FrameCommands& commands, Size size, std::uint32_t frameIndex) {
  const Size before = m_renderSize;
  setRenderSize(size);
  m_resampler.enqueue(commands, m_plan, m_buffers, static_cast<int>((frameIndex + 1) % 2), before, size);
  m_buffers.swapHistories();
}

bool Pipeline::serves(const Configuration& configuration, const MakeSchedule& makeSchedule) const {
  Configuration changed = m_configuration;  // with the lanes that stages have agreed on
  changed.settings = configuration.settings;
  changed.runtime = configuration.runtime;
  const Schedule schedule = makeSchedule(changed);
  if (schedule.size() != m_schedule.size()) return false;
  for (std::size_t i = 0; i < schedule.size(); ++i) {
    if (schedule[i].stage->label() != m_schedule[i].stage->label()) return false;
    Configuration tuned = m_stageConfigurations[i];
    tuned.settings = changed.settings;
    tuned.runtime = changed.runtime;
    for (const KernelUse& use : kernelUses(*schedule[i].stage, tuned))
      if (!m_programs.find(use)) return false;
  }
  return makePlan(schedule, changed) == m_plan;
}

void Pipeline::retune(const Configuration& configuration, const MakeSchedule& makeSchedule,
                      const cl::Context& context, const cl::Device& device, const ProgramCache& cache) {
  m_configuration.settings = configuration.settings;
  m_configuration.runtime = configuration.runtime;
  for (Configuration& tuned : m_stageConfigurations) {
    tuned.settings = configuration.settings;
    tuned.runtime = configuration.runtime;
  }
  m_schedule = makeSchedule(m_configuration);
  buildStages(context, device, cache, {});
}

void Pipeline::record(FrameCommands& commands, const Frame& frame, const Output& output,
                      const ReprojectionParams& reprojection, std::uint32_t frameIndex) const {
  for (std::size_t i = 0; i < m_schedule.size(); ++i)
    recordStage(i, commands, frame, output, reprojection, frameIndex);
}

void Pipeline::recordStage(std::size_t index, FrameCommands& commands, const Frame& frame,
                           const Output& output, const ReprojectionParams& reprojection,
                           std::uint32_t frameIndex) const {
  const bool last = index + 1 == m_schedule.size();
  FrameRun run(m_stageConfigurations[index], frame, output, reprojection, frameIndex,
               m_buffers.arguments(m_plan.rows[index], m_configuration, frame, output,
                                   static_cast<int>(frameIndex % 2)),
               [&](const cl::Kernel& kernel, const cl::NDRange& range, const cl::NDRange& local) {
                 commands.enqueue(index, last, kernel, range, local);
               });
  m_schedule[index].stage->enqueue(run);
}

std::vector<std::string> Pipeline::stageNames() const {
  std::vector<std::string> names;
  for (const StageRow& row : m_schedule) names.push_back(row.stage->name());
  return names;
}

std::vector<std::string> Pipeline::stageLabels() const {
  std::vector<std::string> labels;
  for (const StageRow& row : m_schedule) labels.push_back(row.stage->label());
  return labels;
}

std::vector<std::uint64_t> Pipeline::stageBytes(const Frame& frame, const Content& content) const {
  Configuration now = renderedConfiguration();
  now.frame.camera = frame.camera;
  std::vector<std::uint64_t> bytes;
  for (const StageRow& row : m_schedule) bytes.push_back(quell::stageBytes(*row.stage, now, content));
  return bytes;
}

bool Pipeline::leavesOutBackground() const { return m_plan.find(kSurfacesBuffer) >= 0; }

std::vector<Coverage> Pipeline::coverages(const Frame& frame) const {
  Configuration now = m_configuration;
  now.frame.camera = frame.camera;
  std::vector<Coverage> coverages;
  for (const StageRow& row : m_schedule) coverages.push_back(coverageOf(*row.stage, now));
  return coverages;
}

std::vector<std::uint8_t> Pipeline::surfaces(const cl::CommandQueue& queue) const {
  std::vector<std::uint8_t> map(static_cast<std::size_t>(surfaceItemCount(renderedConfiguration())));
  queue.enqueueReadBuffer(m_buffers.current(m_plan.find(kSurfacesBuffer), 0), CL_TRUE, 0, map.size(),
                          map.data());
  return map;
}

}  // namespace quell
