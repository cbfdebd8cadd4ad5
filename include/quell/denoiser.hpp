// The denoiser: works on the caller's context, device, queue and buffers.
#pragma once

#include <CL/cl.h>
#include <quell/api.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <quell/check.hpp>
#include <quell/error.hpp>
#include <quell/frame.hpp>
#include <quell/settings.hpp>
#include <quell/timings.hpp>
#include <string>
#include <vector>

namespace quell {

/// Whether and how frames are timed.
enum class TimerMode {
  Off,     ///< not at all
  Device,  ///< needs a queue with CL_QUEUE_PROFILING_ENABLE; falls back to Host where events carry no times
  Host,    ///< completion callbacks
};

/// How per-pixel work is spread over work-items.
enum class Mapping {
  Automatic,  ///< as measured by `quell tune-device`, else Wide on CPU devices, Narrow elsewhere
  Narrow,     ///< one pixel a work-item
  Wide,    ///< as many pixels of a row a work-item as fill the device's native vector of floats: 4, 8 or 16
  Wide4,   ///< four of them, whatever the device
  Wide8,   ///< eight of them
  Wide16,  ///< sixteen of them
};

/// What a denoiser is made with, for good. The defaults suit a renderer.
struct Options {
  TimerMode timers = TimerMode::Off;     ///< for timings(); costs an event a kernel
  Mapping mapping = Mapping::Automatic;  ///< results differ by rounding at most
  /// Work-group of the per-pixel kernels, work-items in x and y; 0: as measured by `quell tune-device`,
  /// else chosen from what device and kernel allow.
  std::array<int, 2> workGroup{0, 0};
  /// Work-items that share a block in the fit, a power of two up to 256; 0: chosen. Brought into the range of
  /// the kernel: 16 to 256 (`householder`) or 2 to 256 (`gram`), with the wide mappings 1 to 256 by their lanes, or 1.
  int fitGroup = 0;
  /// Where compiled kernels are kept. Absent: $XDG_CACHE_HOME/quell or ~/.cache/quell, but not the kernels of PoCL, which
  /// compiles each twice to give it away and keeps machine code itself: those only in a directory that is named here, for a
  /// start that is quicker by tenths of a second. Empty string: nowhere.
  std::optional<std::string> cacheDirectory;
  /// Intermediate buffers of the method that keep their memory to the end of the frame, for Denoiser::readBuffer(); by
  /// name, as Denoiser::bufferNames() lists them. Others may share memory with later ones. prepare() throws
  /// Error(InvalidArgument) for a name that is none of them.
  std::vector<std::string> keptBuffers = {};
  /// For bug reports: each prepare() begins a new folder in this one, into which frames are written with all that it takes
  /// to run them again bit for bit (quell/replay.hpp). Absent: the environment variable QUELL_CAPTURE, and nowhere where
  /// that is not set; empty: nowhere. Costs time and host memory; says what went wrong in captureState() alone.
  std::optional<std::string> captureDirectory = {};
  int captureFrames = 8;  ///< how many frames are written, >= 1
  int captureSkip = 0;    ///< how many frames after prepare() are left out before, >= 0
};

/// Owns one reference to an OpenCL event.
class QUELL_API Event {
 public:
  Event() = default;
  /// Takes over a reference; null is allowed.
  explicit Event(cl_event owned) : m_event(owned) {}
  /// Leaves null behind.
  Event(Event&& other) noexcept : m_event(other.release()) {}
  /// Lets go of the own reference and takes over the other one.
  Event& operator=(Event&& other) noexcept;
  Event(const Event&) = delete;
  Event& operator=(const Event&) = delete;
  ~Event();

  /// The event, which stays owned; null if there is none.
  cl_event get() const { return m_event; }
  /// Hands the reference over, for example to cl::Event(event.release()).
  cl_event release() {
    cl_event event = m_event;
    m_event = nullptr;
    return event;
  }
  /// Blocks until the work is done. Throws Error(DeviceError) if it failed.
  void wait() const;

 private:
  cl_event m_event = nullptr;
};

/// Device memory held by a denoiser.
struct MemoryUse {
  std::size_t totalBytes = 0;  ///< of all buffers
  /// Memory of one buffer, or of several by turns.
  struct Buffer {
    std::string name;       ///< buffers that share memory are named together
    std::size_t bytes = 0;  ///< on the device
  };
  std::vector<Buffer> buffers;  ///< in the order in which a frame touches them first
};

/// Whether a method reads an image, with given settings.
enum class InputUse {
  Unused,
  Optional,  ///< what counts without it says frame_images.h
  Required,
};

/// What a method does with one image of Frame.
struct InputNeed {
  std::string image;                ///< the member of Frame
  InputUse use = InputUse::Unused;  ///< with the settings that were asked about
  std::string
      without;  ///< what counts without it; of positionWorld and viewDepth, of which one is required, the other
};

/// What a method with these settings reads, in the order of frame_images.h, taken from its stages. Needs no device.
QUELL_API std::vector<InputNeed> inputNeeds(const Settings& settings);

/// An intermediate buffer as the latest frame has left it: where a stage leaves out background or has no history, that
/// may be older values. Bytes, halves and integers are converted to floats; integers beyond 2^24 are rounded.
struct BufferContent {
  std::string name;           ///< as Denoiser::bufferNames() has it
  int width = 0;              ///< pixels; of buffers that are not images the number of elements
  int height = 0;             ///< pixels; of buffers that are not images 1
  int planes = 0;             ///< of buffers that are not images 1
  std::vector<float> values;  ///< plane by plane, row by row
};

/// What the latest frame left out because it is background (setting `skip`).
struct BackgroundMap {
  int itemWidth = 0;                     ///< pixels of a row that one work-item takes: 1, 4, 8 or 16
  int columns = 0;                       ///< work-items across
  int rows = 0;                          ///< work-items down, one a row of pixels
  std::vector<std::uint8_t> background;  ///< row by row; 1: all pixels of the work-item are background
  std::vector<std::string> stages;       ///< those that leave them out, by their labels

  /// Share of the work-items that are left out, 0 to 1.
  QUELL_API double share() const;
};

/// What has become of Options::captureDirectory.
struct CaptureState {
  std::string directory;  ///< the folder of the latest prepare(); empty: nothing is captured
  int frames = 0;         ///< that are written there; the others may still be pending
  std::string problem;    ///< a sentence on what ended the capture early; empty: nothing did
};

/// How far a preparation is.
struct PrepareProgress {
  std::string stage;  ///< what has been built or launched last, by its label
  int done = 0;       ///< steps, each a kernel that is built or launched for the first time
  int total = 0;      ///< steps in all, two a stage
};
/// Called on the thread that prepares; may call Denoiser::cancelPrepare() and nothing else of that denoiser.
using PrepareCallback = std::function<void(const PrepareProgress&)>;

/// How to prepare. By default the history starts afresh.
struct PrepareOptions {
  /// Keeps the history where the method has the same buffers as before; after a change of size it is resampled, each pixel
  /// from the nearest one. What cannot be kept starts afresh. Old and new buffers exist together for a while.
  bool keepHistory = false;
  std::optional<Settings> settings = {};  ///< of the same method, instead of those before
  PrepareCallback progress = {};          ///< what it throws ends the preparation, which throws it on
};

/// Where the machine code of a stage would come from.
enum class KernelState {
  Missing,  ///< is compiled (a runtime may have it in a cache of its own, which cannot be asked)
  Cached,   ///< on disk, or in this process
  Built,    ///< by this denoiser
};
/// The kernels of one stage; see Denoiser::kernelStates().
struct StageKernel {
  std::string stage;  ///< by its label
  KernelState state =
      KernelState::Missing;  ///< of that kernel of the stage which is furthest from being built
};

/// Denoises a sequence of frames. One object serves one sequence on one queue at a time; it may be used from several
/// threads by turns, not at once. Objects are independent of each other. Destroying one while its work is
/// pending is safe.
class QUELL_API Denoiser {
 public:
  /// Handles are retained as long as needed. Throws Error(WrongContext) if device or queue do not belong to
  /// the context, Error(InvalidArgument) for null handles, unusable options, or timers without a profiling
  /// queue.
  Denoiser(cl_context context, cl_device_id device, cl_command_queue queue,
           const Settings& settings = Settings(), const Options& options = {});

  /// The same for clhpp wrappers (cl::Context, cl::Device, cl::CommandQueue).
  template <class Context, class Device, class Queue>
  Denoiser(const Context& context, const Device& device, const Queue& queue,
           const Settings& settings = Settings(), const Options& options = {})
      : Denoiser(context(), device(), queue(), settings, options) {}

  /// What was moved from may only be destroyed or assigned to.
  Denoiser(Denoiser&&) noexcept;
  /// Destroys what this one was, which is safe while frames are pending.
  Denoiser& operator=(Denoiser&&) noexcept;
  ~Denoiser();

  /// Builds every kernel for the layouts of these images, allocates all memory and launches every kernel once
  /// at its final work-group size, so that no frame pays for it. Blocks. The images' memory may be null here:
  /// only layouts count, but what is given is checked. May be called again with another size or layout; the history is
  /// reset. Arguments that it refuses change nothing; if building fails, the denoiser is as if never prepared.
  void prepare(const Frame& frame, const Output& output, const PrepareOptions& options = {});

  /// The same on a thread of the denoiser's own; returns at once. Until isReady() denoise() throws Error(NotPrepared), and
  /// everything else answers as before prepare(). What building throws is thrown by the next isReady() or denoise(), once.
  /// Destroying the denoiser, or preparing again, cancels and waits for the program that is being compiled.
  void prepareAsync(const Frame& frame, const Output& output, const PrepareOptions& options = {});
  /// Whether denoise() may be called; does not block.
  bool isReady();
  /// Ends a preparation after the program that is being compiled: it throws Error(NotPrepared). From any thread.
  void cancelPrepare();
  /// What prepare() would have to compile for these layouts, stage by stage; compiles nothing. Throws as memoryNeeded().
  std::vector<StageKernel> kernelStates(const Frame& frame, const Output& output) const;

  /// Enqueues the denoising of one frame; never builds, allocates device memory, copies through the host or
  /// blocks. Work starts when all events of the wait list have completed (on an in-order queue also after all
  /// earlier commands) and is done when the returned event has. Throws Error(NotPrepared) if the size or a
  /// layout differs from what was prepared, Error(WrongContext), Error(InvalidArgument) or Error(OutOfRange)
  /// for unusable buffers, events or cameras, Error(DeviceError) for a wait-list event that has failed; all
  /// of them before anything is enqueued. A frame that fails later restarts the history. Any number of frames may be pending:
  /// they run one after the other on every kind of queue. The queue is flushed.
  /// `queue`: another one of the same context and device for this frame, which comes after the frame before by an event;
  /// null: the constructor's.
  Event denoise(const Frame& frame, const Output& output, const std::vector<cl_event>& waitList = {},
                cl_command_queue queue = nullptr);

  /// Takes other values from the next frame on; the history stays, nothing blocks. Throws Error(InvalidArgument) for
  /// another method, Error(NotPrepared) naming the settings that need prepare() (PrepareOptions::settings), and changes
  /// nothing then.
  void setSettings(const Settings& settings);
  /// Names of the settings whose change to these values needs prepare(); empty before prepare().
  std::vector<std::string> settingsToPrepare(const Settings& settings) const;

  /// Says what is odd about a frame that denoise() would take, and what would cure it: transposed matrices, packed normals,
  /// depth of another kind, motion vectors of another sign, light that was summed up, and more (docs/check.md). For
  /// debugging: reads all images of the frame to the host and blocks, once the events of the wait list have completed; it
  /// launches nothing and needs no prepare(). Takes longer than the frame itself. The frame checked last is kept in
  /// host memory and compared with, so check frames in a row; resetHistory() forgets it. Throws Error(InvalidArgument) or
  /// Error(WrongContext) for unusable layouts, buffers or events, Error(DeviceError), Error(OutOfMemory).
  FrameCheck checkFrame(const Frame& frame, const std::vector<cl_event>& waitList = {});

  /// Forgets all earlier frames, as a cut needs it. Does not block.
  void resetHistory();

  /// What the latest frame left out; empty before the first frame after prepare() or resetHistory(), and for methods and
  /// settings that leave out nothing. Blocks until that frame is done. Throws Error(DeviceError).
  BackgroundMap backgroundMap() const;

  /// The method's intermediate buffers, in the order in which a frame touches them; empty before prepare().
  std::vector<std::string> bufferNames() const;
  /// One of them as the latest frame has left it. Blocks until that frame is done. Throws Error(InvalidArgument) for a name
  /// that is none of bufferNames() or that is not among Options::keptBuffers (histories always are), Error(NotPrepared)
  /// before the first frame after prepare() or resetHistory(), Error(DeviceError).
  BufferContent readBuffer(const std::string& name) const;

  /// Device memory held since prepare(). It does not include the caller's images.
  MemoryUse memoryUse() const;
  /// What prepare() would allocate for these layouts; allocates and builds nothing. Throws as prepare() does for unusable
  /// layouts.
  MemoryUse memoryNeeded(const Frame& frame, const Output& output) const;

  /// What was written of Options::captureDirectory so far.
  CaptureState captureState() const;

  /// Times of all frames that have finished so far; never waits for more. Empty if timers are off.
  Timings timings();
  /// Starts the statistics afresh; frames that are pending still count.
  void clearTimings();

  /// The values that the next frame takes. The reference lives as long as the denoiser and shows later changes.
  const Settings& settings() const;

 private:
  class Implementation;
  friend class Replayer;
  std::unique_ptr<Implementation> m_implementation;
};

}  // namespace quell
