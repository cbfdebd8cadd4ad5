// A method as a table: named buffers, and stages in order with what each reads and writes.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <quell/denoiser.hpp>
#include <string>
#include <vector>

#include "host/core/device_traits.hpp"
#include "host/core/opencl.hpp"
#include "host/core/runtime_settings.hpp"
#include "kernels/common/types.h"

namespace quell {

class Stage;

/// What one element of a buffer is.
enum class Element { Float32, UInt8, UInt32 };

/// A buffer of a method: planes of the image's size (see PlaneParams), or plain elements.
struct BufferSpec {
  std::string name;
  Element element = Element::Float32;
  int planes = 0;            ///< planes of the image's size; 0: `elements` counts
  std::size_t elements = 0;  ///< for buffers that are not images
  bool history = false;      ///< kept for the next frame: double-buffered, never shares memory
};

/// The buffer that tells which work-items have nothing but background; see kernels/common/surfaces.h.
constexpr char kSurfacesBuffer[] = "surfaces";

/// One line of a method's table.
struct StageRow {
  std::unique_ptr<Stage> stage;
  std::vector<std::string> reads;   ///< buffer names; "<name>.prev" is the history of the frame before
  std::vector<std::string> writes;  ///< buffer names
};

struct Schedule {
  std::vector<BufferSpec> buffers;
  std::vector<StageRow> stages;
};

/// Everything that is fixed from prepare() on.
struct Configuration {
  DeviceTraits device;
  Options options;
  Settings settings;
  Frame frame;                   ///< layouts only
  Output output;                 ///< layouts only
  cl::Buffer fBetaTable = {};    ///< empty unless light is divided by F_beta; see FBetaTable
  RuntimeSettings runtime = {};  ///< of `settings`, as Method::runtimeSettings says

  Size size() const { return frame.size; }
};

/// True if `name` is one of the names.
bool contains(const std::vector<std::string>& names, const std::string& name);

/// Work-items of a per-pixel kernel, in x and y.
std::array<std::size_t, 2> pixelItems(const Configuration& configuration);

/// Geometry of the planes of an image of this size.
PlaneParams makePlanes(Size size);

/// Elements that a buffer takes, margins included.
std::size_t elementCount(const BufferSpec& spec, Size size);
/// Bytes of its pixels or elements alone, without margins.
std::uint64_t payloadBytes(const BufferSpec& spec, Size size);
std::size_t elementBytes(Element element);

/// Device memory behind the names of a schedule. Transient buffers whose lifetimes do not overlap share
/// memory.
class BufferSet {
 public:
  BufferSet() = default;
  /// Allocates and fills with zeros (blocks). Throws Error(OutOfMemory) naming the buffer.
  BufferSet(const cl::Context& context, const cl::CommandQueue& queue, const Schedule& schedule, Size size);

  /// The buffer of this name in the frame of this parity; "<name>.prev" gives the history of the frame
  /// before.
  const cl::Buffer& get(const std::string& name, int parity) const;
  MemoryUse memoryUse() const;

 private:
  struct Slot {
    std::vector<std::string> names;
    std::size_t bytes = 0;
    cl::Buffer buffers[2];  // the second for history only
    bool history = false;
  };
  const Slot& slotOf(const std::string& name) const;

  std::vector<Slot> m_slots;
};

}  // namespace quell
