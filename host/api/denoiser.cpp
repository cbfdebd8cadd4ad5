#include <algorithm>

#include "host/api/denoiser_implementation.hpp"
#include "host/core/cl_error.hpp"
#include "host/core/handle_checks.hpp"

namespace quell {

Denoiser::Denoiser(cl_context context, cl_device_id device, cl_command_queue queue, const Settings& settings,
                   const Options& options) {
  checkHandles(context, device, queue);
  checkOptions(options);
  m_implementation = withClErrors("Denoiser", [&] {
    return std::make_unique<Implementation>(context, device, queue, settings, options);
  });
}

Denoiser::Denoiser(Denoiser&&) noexcept = default;
Denoiser& Denoiser::operator=(Denoiser&&) noexcept = default;
Denoiser::~Denoiser() = default;

void Denoiser::prepare(const Frame& frame, const Output& output, const PrepareOptions& options) {
  withClErrors("prepare", [&] { m_implementation->prepare(frame, output, options); });
}

void Denoiser::prepareAsync(const Frame& frame, const Output& output, const PrepareOptions& options) {
  withClErrors("prepareAsync", [&] { m_implementation->prepareAsync(frame, output, options); });
}

bool Denoiser::isReady() {
  return withClErrors("prepareAsync", [&] { return m_implementation->isReady(); });
}

void Denoiser::cancelPrepare() { m_implementation->cancelPrepare(); }

std::vector<StageKernel> Denoiser::kernelStates(const Frame& frame, const Output& output) const {
  return withClErrors("kernelStates", [&] { return m_implementation->kernelStates(frame, output); });
}

Event Denoiser::denoise(const Frame& frame, const Output& output, const std::vector<cl_event>& waitList,
                        cl_command_queue queue) {
  return withClErrors("denoise", [&] { return m_implementation->denoise(frame, output, waitList, queue); });
}

void Denoiser::setSettings(const Settings& settings) {
  withClErrors("setSettings", [&] { m_implementation->setSettings(settings); });
}

std::vector<std::string> Denoiser::settingsToPrepare(const Settings& settings) const {
  return m_implementation->settingsToPrepare(settings);
}

FrameCheck Denoiser::checkFrame(const Frame& frame, const std::vector<cl_event>& waitList) {
  return withClErrors("checkFrame", [&] { return m_implementation->checkFrame(frame, waitList); });
}

void Denoiser::resetHistory() { m_implementation->resetHistory(); }
std::vector<std::string> Denoiser::bufferNames() const { return m_implementation->bufferNames(); }
BufferContent Denoiser::readBuffer(const std::string& name) const {
  return withClErrors("readBuffer", [&] { return m_implementation->readBuffer(name); });
}
MemoryUse Denoiser::memoryUse() const { return m_implementation->memoryUse(); }
MemoryUse Denoiser::memoryNeeded(const Frame& frame, const Output& output) const {
  return withClErrors("memoryNeeded", [&] { return m_implementation->memoryNeeded(frame, output); });
}
CaptureState Denoiser::captureState() const { return m_implementation->captureState(); }
Timings Denoiser::timings() {
  return withClErrors("timings", [&] { return m_implementation->timings(); });
}
void Denoiser::clearTimings() {
  withClErrors("clearTimings", [&] { m_implementation->clearTimings(); });
}
BackgroundMap Denoiser::backgroundMap() const {
  return withClErrors("backgroundMap", [&] { return m_implementation->backgroundMap(); });
}
const Settings& Denoiser::settings() const { return m_implementation->settings(); }

double BackgroundMap::share() const {
  const auto count = std::count(background.begin(), background.end(), std::uint8_t(1));
  return background.empty() ? 0.0 : static_cast<double>(count) / static_cast<double>(background.size());
}

Event& Event::operator=(Event&& other) noexcept {
  if (this != &other) {
    if (m_event != nullptr) clReleaseEvent(m_event);
    m_event = other.release();
  }
  return *this;
}

Event::~Event() {
  if (m_event != nullptr) clReleaseEvent(m_event);
}

void Event::wait() const {
  if (m_event == nullptr) return;
  const cl_int status = clWaitForEvents(1, &m_event);
  if (status != CL_SUCCESS) throw translateClError(status, "clWaitForEvents", "denoise");
}

}  // namespace quell
