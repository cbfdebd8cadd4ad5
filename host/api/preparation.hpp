// What prepare() makes, and how: here and now, or on a thread of its own.
#pragma once

#include <atomic>
#include <exception>
#include <memory>
#include <mutex>
#include <quell/denoiser.hpp>
#include <string>
#include <thread>

#include "host/core/pipeline.hpp"
#include "host/core/program_cache.hpp"
#include "host/methods/method.hpp"

namespace quell {

/// What a denoiser had before.
struct FormerFrames {
  Pipeline pipeline;
  cl::Event last;                ///< of the latest frame
  std::uint32_t frameIndex = 0;  ///< of the next frame; 0: there is no history
};

struct Prepared {
  Configuration configuration;
  Pipeline pipeline;
  std::uint32_t frameIndex = 0;  ///< of the next frame
  bool deviceTimes = false;      ///< whether events carry times
};

/// Everything that it takes, so that it needs nothing of the denoiser.
struct PreparationJob {
  cl::Context context;
  cl::Device device;
  cl_command_queue_properties queueProperties = 0;
  ProgramCache cache;
  const Method* method;
  Configuration configuration;
  FormerFrames former;
  PrepareOptions options;
};

/// Makes room for the tables that a configuration reads.
void needTables(Configuration& configuration);

/// Waits for the frames before, drops them, builds and warms up. `cancelled` is looked at between kernels. Throws what
/// Denoiser::prepare() does.
Prepared runPreparation(PreparationJob job, const std::atomic<bool>& cancelled);

/// A preparation on a thread, which the destructor cancels and waits for.
class Preparation {
 public:
  /// `cancelled` outlives it.
  Preparation(PreparationJob job, std::atomic<bool>& cancelled);
  ~Preparation();
  Preparation(const Preparation&) = delete;
  Preparation& operator=(const Preparation&) = delete;

  bool done() const { return m_done; }
  /// How far it is, in words.
  std::string state() const;
  /// The result of one that is done, once. Throws what it threw.
  Prepared take();

 private:
  void run(PreparationJob job) noexcept;

  std::atomic<bool>& m_cancelled;
  std::atomic<bool> m_done{false};
  mutable std::mutex m_mutex;
  PrepareProgress m_progress;    // guarded
  std::exception_ptr m_failure;  // of the thread until it is done
  Prepared m_result;             // likewise
  std::thread m_thread;
};

}  // namespace quell
