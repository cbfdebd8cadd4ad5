// A method as a table: stages in order, and to which buffers their ports are wired where names alone do not tell.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <quell/denoiser.hpp>
#include <string>
#include <vector>

#include "host/core/device_traits.hpp"
#include "host/core/opencl.hpp"
#include "host/core/ports.hpp"
#include "host/core/runtime_settings.hpp"
#include "kernels/common/types.h"

namespace quell {

class Stage;

/// The buffer that tells which work-items show a surface; see kernels/common/surfaces.h.
constexpr char kSurfacesBuffer[] = "surfaces";

/// Joins a port to a buffer of another name.
struct Wire {
  std::string port;
  std::string buffer;
};

/// One line of a method's table. A port without a wire has the buffer of its own name (Port::usualBuffer).
struct StageRow {
  std::unique_ptr<Stage> stage;
  std::vector<Wire> wires;
};

/// The buffers follow from the ports: element and extent; that one is kept for the next frame, and therefore
/// double-buffered, from a port that reads it then.
using Schedule = std::vector<StageRow>;

/// Everything that is fixed from prepare() on.
struct Configuration {
  DeviceTraits device;
  Options options;
  Settings settings;
  Frame frame;                                    ///< layouts only
  Output output;                                  ///< layouts only
  RuntimeSettings runtime = {};                   ///< of `settings`, as Method::runtimeSettings says
  std::map<std::string, cl::Buffer> tables = {};  ///< behind ports that read a table, by the port's name

  Size size() const { return frame.size; }
};

/// A buffer of a method.
struct BufferSpec {
  std::string name;
  Element element = Element::Float32;
  Extent extent;
  bool history = false;  ///< kept for the next frame: double-buffered, never shares memory
  int firstRow = 0;      ///< of the rows that touch it
  int lastRow = 0;
};

/// A port and what it is wired to.
struct Binding {
  Port port;
  int buffer = -1;  ///< index into Plan::buffers; -1: an image, a table, or nothing

  bool hasBuffer() const { return buffer >= 0; }
};

/// A schedule with all names resolved.
struct Plan {
  std::vector<BufferSpec> buffers;         ///< in the order in which they are first touched
  std::vector<std::vector<Binding>> rows;  ///< per stage, in the order of its ports

  /// Index of a buffer, -1 if there is none of this name.
  int find(const std::string& name) const;
  /// The same; throws Error(InvalidArgument) that names `function`, `argument` and all buffers if there is none.
  int require(const std::string& name, const char* function, const char* argument) const;
};

/// Whether the same buffers are bound to the same ports; names and rows decide.
bool operator==(const Plan& a, const Plan& b);

/// Throws std::logic_error naming row, port, what was expected and what came: a wire of a port that the stage does not
/// have; ports of one buffer that differ in element or extent; a buffer that is read before any stage has written it;
/// one that a stage reads and writes through different ports; a table that is not there.
Plan makePlan(const Schedule& schedule, const Configuration& configuration);

/// Work-items of a per-pixel kernel, in x and y.
std::array<std::size_t, 2> pixelItems(const Configuration& configuration);
/// Elements of kSurfacesBuffer.
int surfaceItemCount(const Configuration& configuration);

/// Geometry of the planes of an image of this size.
PlaneParams makePlanes(Size size);

/// Elements that a buffer takes, margins included.
std::size_t elementCount(const BufferSpec& spec, Size size);

}  // namespace quell
