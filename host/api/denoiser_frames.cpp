// Frames on their way into the queue.
#include <utility>

#include "host/api/denoiser_implementation.hpp"
#include "host/core/handle_checks.hpp"
#include "host/core/memory_checks.hpp"
#include "host/core/render_rectangle.hpp"
#include "host/core/reprojection.hpp"
#include "host/core/validation.hpp"

namespace quell {
namespace {

cl_event retain(cl_event event) {
  clRetainEvent(event);
  return event;
}

bool isOutOfOrder(const cl::CommandQueue& queue) {
  return (queue.getInfo<CL_QUEUE_PROPERTIES>() & CL_QUEUE_OUT_OF_ORDER_EXEC_MODE_ENABLE) != 0;
}

}  // namespace

Event Denoiser::Implementation::denoise(const Frame& frame, const Output& output,
                                        const std::vector<cl_event>& waitList, cl_command_queue givenQueue) {
  if (!isReady())
    throw Error(ErrorCode::NotPrepared, {"denoise", "", "a call of prepare() before",
                                         m_preparation ? m_preparation->state() : "none that succeeded"});
  const cl::CommandQueue queue = queueFor(givenQueue);
  checkSameSize(m_configuration.frame, frame);
  if (!hasRenderSize(frame)) return denoisePart(frame, output, waitList, queue);
  return denoisePart(renderedPart(frame), renderedPart(output, frame), waitList, queue);
}

Event Denoiser::Implementation::denoisePart(const Frame& frame, const Output& output,
                                            const std::vector<cl_event>& waitList,
                                            const cl::CommandQueue& queue) {
  checkSameLayout(m_configuration.frame, m_configuration.output, frame, output);
  checkNumbers("denoise", frame);
  checkMemory("denoise", frame, output, m_context());
  checkHalfPositions(frame);
  checkPerspective("denoise", frame);
  std::vector<cl::Event> waitFor = checkedEvents(waitList, m_context);
  forgetFailedFrame();
  if (m_lastEvent() != nullptr &&
      (isOutOfOrder(queue) || m_lastEvent.getInfo<CL_EVENT_COMMAND_QUEUE>()() != queue()))
    waitFor.push_back(m_lastEvent);
  waitFor = changeRenderSize(queue, frame.size, std::move(waitFor));
  const bool captured = m_capture && m_capture->takesNext();
  const cl::Event last = captured ? recordCaptured(queue, frame, output, std::move(waitFor))
                                  : record(queue, frame, output, std::move(waitFor));
  return Event(retain(last()));
}

cl::CommandQueue Denoiser::Implementation::queueFor(cl_command_queue given) const {
  if (given == nullptr || given == m_queue()) return m_queue;
  cl::CommandQueue queue(given, true);
  checkQueue("denoise", m_context, m_device, queue, m_configuration.options);
  return queue;
}

// A frame that failed leaves no history, and nothing may wait for it: that would fail as well.
void Denoiser::Implementation::forgetFailedFrame() {
  if (m_events.takeFailed()) m_frameIndex = 0;
  if (!hasFailed(m_lastEvent)) return;
  m_lastEvent = cl::Event();
  m_frameIndex = 0;
}

Camera Denoiser::Implementation::withPrevious(Camera camera) const {
  if (camera.worldToClipPrev == Matrix4{}) camera.worldToClipPrev = m_latestFrame.camera.worldToClip;
  return camera;
}

cl::Event Denoiser::Implementation::recordCaptured(const cl::CommandQueue& queue, const Frame& frame,
                                                   const Output& output, std::vector<cl::Event> waitFor) {
  const Camera camera = withPrevious(frame.camera);
  m_capture->readInputs(queue, frame, output,
                        {m_configuration.settings, m_frameIndex, camera.worldToClipPrev}, m_pipeline,
                        waitFor);
  try {
    m_lastEvent = m_capture->readOutputs(queue, record(queue, frame, output, std::move(waitFor)));
  } catch (...) {
    m_capture->dropFrame();
    m_events.keep(m_capture->events());
    throw;
  }
  m_events.keep(m_capture->events());
  return m_lastEvent;
}

/// What the frame is to wait for then.
std::vector<cl::Event> Denoiser::Implementation::changeRenderSize(const cl::CommandQueue& queue, Size size,
                                                                  std::vector<cl::Event> waitFor) {
  if (m_pipeline.renderSize() == size) return waitFor;
  if (m_frameIndex == 0) {
    m_pipeline.setRenderSize(size);
    return waitFor;
  }
  const bool chain = isOutOfOrder(queue) || !waitFor.empty();
  FrameCommands commands(queue, std::move(waitFor), chain, false);
  try {
    m_pipeline.resampleHistories(commands, size, m_frameIndex);
  } catch (...) {
    abandonFrame(commands);
    throw;
  }
  m_events.keep(commands.events());
  if (!chain) return {};
  m_lastEvent = commands.lastEvent();
  return {m_lastEvent};
}

// Whatever was enqueued still runs: later frames come after it, and start afresh.
void Denoiser::Implementation::abandonFrame(const FrameCommands& commands) {
  if (commands.lastEvent()() != nullptr) m_lastEvent = commands.lastEvent();
  m_frameIndex = 0;
  if (commands.isChain()) m_events.keep(commands.events());
}

cl::Event Denoiser::Implementation::record(const cl::CommandQueue& queue, const Frame& frame,
                                           const Output& output, std::vector<cl::Event> waitFor) {
  const ReprojectionParams reprojection =
      makeReprojectionParams(withPrevious(frame.camera), frame.size, m_configuration.runtime.discard,
                             m_frameIndex > 0, frame.motionScale);
  // On an in-order queue the chain carries on what a failing event of the wait list means for later kernels.
  const bool chain = isOutOfOrder(queue) || !waitFor.empty();
  FrameCommands commands(queue, std::move(waitFor), chain, m_timer != nullptr);
  try {
    m_pipeline.record(commands, frame, output, reprojection, m_frameIndex);
    queue.flush();  // hands the work to the device; does not wait
  } catch (...) {
    abandonFrame(commands);
    throw;
  }
  m_lastEvent = commands.lastEvent();
  m_latestFrame = frame;
  ++m_frameIndex;
  if (m_timer) {
    for (const auto& [stage, event] : commands.events()) m_timer->add(stage, event);
    m_timer->endFrame();
  }
  if (chain) m_events.keep(commands.events());
  return m_lastEvent;
}

}  // namespace quell
