// Writes the first frames after prepare() into a folder (Options::captureDirectory), without waiting for any.
#pragma once

#include <memory>
#include <quell/denoiser.hpp>
#include <string>
#include <vector>

#include "host/api/captured_frame.hpp"
#include "host/core/frame_commands.hpp"
#include "host/core/pipeline.hpp"

namespace quell {

/// Where Options and environment want captures; empty: nowhere.
std::string captureDirectory(const Options& options);

CapturedFacts factsOf(const Configuration& configuration);

class Capture {
 public:
  /// Begins a new folder in `directory`, which is made where there is none.
  Capture(const std::string& directory, const Configuration& configuration);
  /// Waits until what is complete is written; what is pending is written when it ends.
  ~Capture();
  Capture(const Capture&) = delete;
  Capture& operator=(const Capture&) = delete;

  /// Whether the next frame is one that is written; counts.
  bool takesNext();

  /// What the frames are run with that are not images.
  struct Facts {
    const Settings& settings;
    std::uint32_t frameIndex;
    Matrix4 worldToClipPrev;
  };
  /// Enqueues reads of what the frame's images hold and, for the first frame that is written, of the histories. The frame's
  /// kernels must wait for what is then in `waitFor`. Never throws: a problem ends the capture.
  void readInputs(const cl::CommandQueue& queue, const Frame& frame, const Output& output, const Facts& facts,
                  const Pipeline& pipeline, std::vector<cl::Event>& waitFor);
  /// Enqueues reads of the outputs after the frame's `last` event. The frame is done, for the caller as well, when what is
  /// returned is. Never throws.
  cl::Event readOutputs(const cl::CommandQueue& queue, const cl::Event& last);
  /// The frame could not be enqueued.
  void dropFrame();

  /// Events of the frame's reads, in order.
  const EventChain& events() const { return m_events; }
  CaptureState state() const;

 private:
  struct Folder;
  struct Shot;
  void open(const std::string& directory, const Configuration& configuration);
  void begin(const cl::CommandQueue& queue, const Frame& frame, const Output& output, const Facts& facts,
             const Pipeline& pipeline);
  void end(const cl::CommandQueue& queue);
  void read(const cl::CommandQueue& queue, cl_mem handle, const CapturedMemory& memory, std::size_t begin,
            Bytes& bytes);
  void readHistories(const cl::CommandQueue& queue, const Pipeline& pipeline);
  void fail(const std::string& problem);

  std::shared_ptr<Folder> m_folder;
  std::vector<std::shared_ptr<Shot>> m_shots;  // that may still be pending
  std::shared_ptr<Shot> m_shot;                // of the frame that is being enqueued
  std::vector<cl_mem> m_handles;               // of its memory objects
  std::vector<cl::Event> m_waitFor;            // of the next read
  EventChain m_events;
  int m_skip = 0, m_left = 0, m_number = 0;
};

}  // namespace quell
