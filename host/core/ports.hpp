// Ports of a stage as the host has them: made from the lists in kernels/<stem>_ports.h, see kernels/common/ports.h.
#pragma once

#include <cstddef>
#include <cstdint>
#include <quell/frame.hpp>
#include <string>
#include <vector>

namespace quell {

struct Configuration;

/// What one element of a buffer is.
enum class Element { Float32, Float16, UInt8, Int32, Float32x4 };
std::size_t elementBytes(Element element);
const char* toString(Element element);

enum class Access {
  Read,
  Previous,  ///< read of the frame before
  Write,
  Update,   ///< read and written
  Scratch,  ///< written and then read by the stage itself
  Table,    ///< read of a table that the runtime provides
};

/// How large a buffer is: planes of the image's size (see PlaneParams), or plain elements.
struct Extent {
  Extent() = default;
  Extent(std::int64_t planeCount)
      : planes(static_cast<int>(planeCount)) {}  // NOLINT: a number of planes is an extent
  static Extent records(std::size_t count) {
    Extent extent;
    extent.elements = count;
    return extent;
  }

  int planes = 0;            ///< 0: `elements` counts
  std::size_t elements = 0;  ///< for buffers that are not images
};
bool operator==(const Extent& a, const Extent& b);
std::string toString(const Extent& extent);

/// What the pixels of a frame show, as shares of its work-items, 0 to 1: what the bytes that a stage touches depend on.
/// The defaults are a frame of surfaces with long histories under steady light.
struct Content {
  double surfaces = 1.0;        ///< show a surface
  int frames = 255;             ///< since the history was reset, this one included
  double histories = 1.0;       ///< have a history
  double shortHistories = 0.0;  ///< of those with a surface: have a history too short for its variance
  double changed = 0.0;         ///< of those with a surface: the light has changed
  double nearSurfaces = 0.0;    ///< of the background: next to a surface
};

/// One port, for one configuration.
struct Port {
  const char* name = "";
  Access access = Access::Read;
  bool exists = true;
  double touched = 1.0;  ///< share that a frame touches, 0 to 1, each element counted once

  // A buffer of the method.
  Element element = Element::Float32;
  Extent extent;

  // Or an image of the caller; `options` is its name in compile options.
  const ImageView Frame::*input = nullptr;
  const ImageView Output::*output = nullptr;
  const char* options = "";
  bool asGiven = false;  ///< the caller's image itself, where others read it as imported

  bool isImage() const { return input != nullptr || output != nullptr; }
  /// Of the kernel: absent inputs are none, see kernels/common/ports.h.
  bool isArgument() const { return exists || input == nullptr; }
  bool writes() const {
    return access == Access::Write || access == Access::Update || access == Access::Scratch;
  }
  /// The buffer that the port is wired to unless the method's row says otherwise: of its own name, without "Prev" where
  /// that of the frame before is read.
  std::string usualBuffer() const;
  /// The view of the image as stages read it, imported or not; absent where the port is.
  ImageView view(const Frame& frame, const Output& out) const;
};

/// Bytes that a frame of this size touches through the port; what is updated counts twice.
double touchedBytes(const Port& port, const Configuration& configuration);

// The struct `Type` of the compile options and sizes of a stage, as members of the names that its ports use, and its
// ports. Belongs into the stage's header; QUELL_PORTS(Type, STEM) into its source file, after host/core/port_columns.hpp.
// `stem` names the kernel.
#define QUELL_OPTION_MEMBER(name) int name = 0;
#define QUELL_SIZE_MEMBER(name) std::int64_t name = 0;
#define QUELL_OPTIONS(Type, STEM, stem)                                                            \
  struct Type {                                                                                    \
    static constexpr char kStem[] = stem;                                                          \
    STEM##_OPTIONS(QUELL_OPTION_MEMBER, QUELL_SIZE_MEMBER) std::string defines() const;            \
    std::vector<Port> makePorts(const Configuration& configuration, const Content& content) const; \
  };

}  // namespace quell
