#include "host/core/pipeline.hpp"

#include <algorithm>
#include <utility>

namespace quell {
namespace {

/// Whether the row touches the buffer that says where surfaces are.
bool touches(const std::vector<Binding>& row, int buffer) {
  return std::any_of(row.begin(), row.end(),
                     [&](const Binding& binding) { return binding.hasBuffer() && binding.buffer == buffer; });
}

}  // namespace

Pipeline::Pipeline(const cl::Context& context, const cl::Device& device, const cl::CommandQueue& queue,
                   const ProgramCache& cache, Configuration configuration, const MakeSchedule& makeSchedule)
    : m_configuration(std::move(configuration)) {
  const DeviceTuning tuning = readTuning(cache.disk(), m_configuration.device.identity);
  plan(tuning, makeSchedule);
  buildStages(context, device, cache, tuning);
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

void Pipeline::buildStages(const cl::Context& context, const cl::Device& device, const ProgramCache& cache,
                           const DeviceTuning& tuning) {
  const int surfaces = m_plan.find(kSurfacesBuffer);
  m_stageConfigurations.reserve(m_schedule.size());  // kernel builders refer to them
  for (std::size_t i = 0; i < m_schedule.size(); ++i) {
    m_stageConfigurations.push_back(m_configuration);
    Configuration& tuned = m_stageConfigurations.back();
    applyTuning(tuning, m_schedule[i].stage->name(), tuned);
    if (touches(m_plan.rows[i], surfaces) && tuned.device.lanes != m_configuration.device.lanes)
      tuned = m_configuration;
    m_schedule[i].stage->build(DeviceKernelBuilder(context, device, cache, tuned));
  }
}

void Pipeline::record(FrameCommands& commands, const Frame& frame, const Output& output,
                      const ReprojectionParams& reprojection, std::uint32_t frameIndex) const {
  for (std::size_t i = 0; i < m_schedule.size(); ++i) {
    const bool last = i + 1 == m_schedule.size();
    FrameRun run(
        m_stageConfigurations[i], frame, output, reprojection, frameIndex,
        m_buffers.arguments(m_plan.rows[i], m_configuration, frame, output, static_cast<int>(frameIndex % 2)),
        [&](const cl::Kernel& kernel, const cl::NDRange& range, const cl::NDRange& local) {
          commands.enqueue(i, last, kernel, range, local);
        });
    m_schedule[i].stage->enqueue(run);
  }
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
  Configuration now = m_configuration;
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
  std::vector<std::uint8_t> map(static_cast<std::size_t>(surfaceItemCount(m_configuration)));
  queue.enqueueReadBuffer(m_buffers.current(m_plan.find(kSurfacesBuffer), 0), CL_TRUE, 0, map.size(),
                          map.data());
  return map;
}

}  // namespace quell
