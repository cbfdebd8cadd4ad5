// What a denoiser tells of its frames: times, bytes, what was left out, intermediate buffers.
#include <algorithm>

#include "host/api/denoiser_implementation.hpp"
#include "host/core/buffer_reader.hpp"
#include "host/core/handle_checks.hpp"
#include "host/core/render_rectangle.hpp"
#include "host/core/validation.hpp"
#include "kernels/common/guides.h"

namespace quell {
namespace {

bool isComplete(const cl::Event& event) {
  return event() != nullptr && event.getInfo<CL_EVENT_COMMAND_EXECUTION_STATUS>() == CL_COMPLETE;
}

/// Share of a stage's work that it leaves out of a frame of this content; nothing where it leaves out none.
std::optional<double> skippedShare(Coverage coverage, const Content& content) {
  if (coverage == Coverage::Everything) return std::nullopt;
  return 1.0 - coveredShare(coverage, content);
}

}  // namespace

void Denoiser::Implementation::startTimer(bool deviceTimes) {
  const TimerMode mode = m_configuration.options.timers;
  if (mode == TimerMode::Off) return;
  const bool device = mode == TimerMode::Device && deviceTimes;
  m_timer =
      std::make_unique<FrameTimer>(m_pipeline.stageNames(), device ? TimeSource::Device : TimeSource::Host);
  if (m_pipeline.leavesOutBackground()) m_readQueue = cl::CommandQueue(m_context, m_device);
}

/// Reads which work-items showed a surface if the latest frame is done; never waits for one that is not.
Content Denoiser::Implementation::latestContent() {
  if (m_frameIndex > 0 && m_pipeline.leavesOutBackground() && isComplete(m_lastEvent)) {
    const std::vector<std::uint8_t> map = m_pipeline.surfaces(m_readQueue);
    m_content.surfaces = static_cast<double>(std::count(map.begin(), map.end(), std::uint8_t(1))) /
                         static_cast<double>(map.size());
    m_contentKnown = true;
  }
  m_content.frames = static_cast<int>(std::min<std::uint32_t>(m_frameIndex, QUELL_MAX_HISTORY_LENGTH));
  return m_content;
}

Timings Denoiser::Implementation::timings() {
  if (!m_timer) return {};
  Timings timings = m_timer->collect();
  const Content content = latestContent();
  const std::vector<std::string> labels = m_pipeline.stageLabels();
  const std::vector<std::uint64_t> bytes = m_pipeline.stageBytes(m_latestFrame, content);
  const std::vector<Coverage> coverages = m_pipeline.coverages(m_latestFrame);
  for (std::size_t i = 0; i < timings.stages.size(); ++i) {
    timings.stages[i].label = labels[i];
    timings.stages[i].bytesMoved = bytes[i];
    if (m_contentKnown) timings.stages[i].skippedShare = skippedShare(coverages[i], content);
  }
  return timings;
}

void Denoiser::Implementation::clearTimings() {
  if (m_timer) m_timer->clear();
}

BackgroundMap Denoiser::Implementation::backgroundMap() const {
  if (!m_pipeline.leavesOutBackground() || m_frameIndex == 0) return {};
  BackgroundMap map;
  const std::vector<std::string> labels = m_pipeline.stageLabels();
  const std::vector<Coverage> coverages = m_pipeline.coverages(m_latestFrame);
  for (std::size_t i = 0; i < labels.size(); ++i)
    if (leavesOutBackground(coverages[i])) map.stages.push_back(labels[i]);
  const auto [columns, rows] = pixelItems(m_pipeline.renderedConfiguration());
  map.itemWidth = m_pipeline.configuration().device.lanes;
  map.columns = static_cast<int>(columns);
  map.rows = static_cast<int>(rows);
  m_lastEvent.wait();  // a read that waited for a failed frame would never end on some runtimes
  map.background = m_pipeline.surfaces(m_queue);
  for (std::uint8_t& flag : map.background) flag = flag == 0 ? 1 : 0;
  return map;
}

FrameCheck Denoiser::Implementation::checkFrame(const Frame& frame, const std::vector<cl_event>& waitList) {
  checkSizes("checkFrame", frame);
  const Frame part = renderedPart(frame);
  checkInputs("checkFrame", part, m_context());
  return m_checker.check(m_queue, part, checkedEvents(waitList, m_context));
}

std::vector<std::string> Denoiser::Implementation::bufferNames() const {
  std::vector<std::string> names;
  for (const BufferSpec& spec : m_pipeline.plan().buffers) names.push_back(spec.name);
  return names;
}

BufferContent Denoiser::Implementation::readBuffer(const std::string& name) const {
  if (m_frameIndex == 0)
    throw Error(ErrorCode::NotPrepared,
                {"readBuffer", name, "a frame since prepare() or resetHistory()", "none"});
  const int index = m_pipeline.plan().require(name, "readBuffer", "name");
  const BufferSpec& spec = m_pipeline.plan().buffers[static_cast<std::size_t>(index)];
  const std::vector<std::string>& kept = m_configuration.options.keptBuffers;
  if (!spec.history && std::find(kept.begin(), kept.end(), name) == kept.end())
    throw Error(ErrorCode::InvalidArgument,
                {"readBuffer", name, "a buffer among Options::keptBuffers", "one that may share its memory"});
  m_lastEvent.wait();
  const int parity = static_cast<int>((m_frameIndex - 1) % 2);
  return readBufferContent(m_queue, m_pipeline.buffers().current(index, parity), spec,
                           m_pipeline.renderSize());
}

}  // namespace quell
