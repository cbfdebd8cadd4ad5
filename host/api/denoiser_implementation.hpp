// What is behind quell::Denoiser.
#pragma once

#include <memory>
#include <quell/denoiser.hpp>
#include <string>
#include <vector>

#include "host/api/frame_checker.hpp"
#include "host/core/event_keeper.hpp"
#include "host/core/frame_timer.hpp"
#include "host/core/pipeline.hpp"
#include "host/core/program_cache.hpp"
#include "host/methods/method.hpp"

namespace quell {

class Denoiser::Implementation {
 public:
  Implementation(cl_context context, cl_device_id device, cl_command_queue queue, const Settings& settings,
                 const Options& options);

  void prepare(const Frame& frame, const Output& output);
  Event denoise(const Frame& frame, const Output& output, const std::vector<cl_event>& waitList);
  FrameCheck checkFrame(const Frame& frame, const std::vector<cl_event>& waitList);
  void resetHistory() {
    m_frameIndex = 0;
    m_checker.forget();
  }

  MemoryUse memoryNeeded(const Frame& frame, const Output& output) const;
  MemoryUse memoryUse() const { return m_pipeline.buffers().memoryUse(); }
  std::vector<std::string> bufferNames() const;
  BufferContent readBuffer(const std::string& name) const;
  BackgroundMap backgroundMap() const;
  Timings timings();
  void clearTimings();
  const Settings& settings() const { return m_configuration.settings; }

 private:
  void unprepare();
  Configuration configurationFor(const Frame& frame, const Output& output) const;
  void makeTables();
  void warmUp();
  void startTimer();
  void forgetFailedFrame();
  cl::Event record(const Frame& frame, const Output& output, std::vector<cl::Event> waitFor);
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
  std::uint32_t m_frameIndex = 0;
  bool m_outOfOrder = false;
  bool m_prepared = false;
};

}  // namespace quell
