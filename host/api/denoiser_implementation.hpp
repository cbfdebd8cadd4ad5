// What is behind quell::Denoiser.
#pragma once

#include <atomic>
#include <memory>
#include <quell/denoiser.hpp>
#include <string>
#include <vector>

#include "host/api/capture.hpp"
#include "host/api/frame_checker.hpp"
#include "host/api/preparation.hpp"
#include "host/core/event_keeper.hpp"
#include "host/core/frame_timer.hpp"
#include "host/core/pipeline.hpp"
#include "host/core/program_cache.hpp"
#include "host/methods/method.hpp"

namespace quell {

class QUELL_HIDDEN Denoiser::Implementation {
 public:
  Implementation(cl_context context, cl_device_id device, cl_command_queue queue, const Settings& settings,
                 const Options& options);

  void prepare(const Frame& frame, const Output& output, const PrepareOptions& options);
  void prepareAsync(const Frame& frame, const Output& output, const PrepareOptions& options);
  bool isReady();
  void cancelPrepare() { m_cancelled = true; }
  std::vector<StageKernel> kernelStates(const Frame& frame, const Output& output) const;
  Event denoise(const Frame& frame, const Output& output, const std::vector<cl_event>& waitList,
                cl_command_queue queue);
  void setSettings(const Settings& settings);
  std::vector<std::string> settingsToPrepare(const Settings& settings) const;
  FrameCheck checkFrame(const Frame& frame, const std::vector<cl_event>& waitList);
  void resetHistory() {
    m_frameIndex = 0;
    m_historyIsKept = false;
    m_checker.forget();
  }

  MemoryUse memoryNeeded(const Frame& frame, const Output& output) const;
  MemoryUse memoryUse() const { return m_pipeline.buffers().memoryUse(); }
  std::vector<std::string> bufferNames() const;
  BufferContent readBuffer(const std::string& name) const;
  BackgroundMap backgroundMap() const;
  CaptureState captureState() const { return m_capture ? m_capture->state() : CaptureState(); }
  Timings timings();
  void clearTimings();
  const Settings& settings() const { return m_configuration.settings; }

  // For Replayer.
  const Configuration& configuration() const { return m_pipeline.configuration(); }
  std::vector<BufferSet::History> histories() const { return m_pipeline.buffers().histories(); }
  void continueFrom(std::uint32_t frameIndex) { m_frameIndex = frameIndex; }
  void setRenderSize(Size size) { m_pipeline.setRenderSize(size); }

 private:
  FormerFrames takeFormerFrames();
  PreparationJob jobFor(const Frame& frame, const Output& output, const PrepareOptions& options);
  void adopt(Prepared prepared);
  Configuration configurationFor(Configuration configuration, const Frame& frame, const Output& output) const;
  Configuration configurationWith(const Settings& settings) const;
  void startTimer(bool deviceTimes);
  void forgetFailedFrame();
  Camera withPrevious(Camera camera) const;
  cl::CommandQueue queueFor(cl_command_queue given) const;
  Event denoisePart(const Frame& frame, const Output& output, const std::vector<cl_event>& waitList,
                    const cl::CommandQueue& queue);
  std::vector<cl::Event> changeRenderSize(const cl::CommandQueue& queue, Size size,
                                          std::vector<cl::Event> waitFor);
  void abandonFrame(const FrameCommands& commands);
  cl::Event record(const cl::CommandQueue& queue, const Frame& frame, const Output& output,
                   std::vector<cl::Event> waitFor);
  cl::Event recordCaptured(const cl::CommandQueue& queue, const Frame& frame, const Output& output,
                           std::vector<cl::Event> waitFor);
  Content latestContent();

  cl::Context m_context;
  cl::Device m_device;
  cl::CommandQueue m_queue;
  ProgramCache m_cache;
  const Method& m_method;
  Configuration m_configuration;
  Pipeline m_pipeline;
  std::unique_ptr<FrameTimer> m_timer;
  cl::CommandQueue
      m_readQueue;    // of our own: reads of finished frames wait for nothing that the caller enqueues
  Content m_content;  // of the latest frame that is known to be done
  bool m_contentKnown = false;
  Frame m_latestFrame;  // layouts and camera
  cl::Event m_lastEvent;
  EventKeeper m_events;  // of frames that may still be pending
  FrameChecker m_checker;
  std::unique_ptr<Capture> m_capture;
  std::uint32_t m_frameIndex = 0;
  bool m_historyIsKept = false;  // by a preparation that is under way
  bool m_prepared = false;
  std::atomic<bool> m_cancelled{false};
  std::unique_ptr<Preparation> m_preparation;  // that is under way; the first to go
};

}  // namespace quell
