// Types of the parameter structs that device, host and oracles share: 32-bit scalars and 4-vectors only, widest
// first, so that every compiler lays them out alike (a 3-vector has a different size on each side).
#ifndef QUELL_COMMON_TYPES_H
#define QUELL_COMMON_TYPES_H

#ifdef __OPENCL_C_VERSION__
typedef int QuellInt;
typedef uint QuellUint;
typedef float QuellFloat;
typedef float4 QuellFloat4;
#else
#include <cstdint>
namespace quell {
using QuellInt = std::int32_t;
using QuellUint = std::uint32_t;
using QuellFloat = float;
struct alignas(16) QuellFloat4 {
  float x, y, z, w;
};
}  // namespace quell
#endif

#ifdef __OPENCL_C_VERSION__
#define QUELL_NAMESPACE_BEGIN
#define QUELL_NAMESPACE_END
#else
#define QUELL_NAMESPACE_BEGIN namespace quell {
#define QUELL_NAMESPACE_END }
#endif

QUELL_NAMESPACE_BEGIN

// Where the pixels of a caller's image lie. The component count, format and distance between pixels are compile
// options of the kernel (see common/image_access.h), since they decide which instructions load a row.
typedef struct ImageViewParams {
  QuellInt offset;    // components (floats or halves) before pixel (0, 0)
  QuellInt rowPitch;  // components from one row to the next
} ImageViewParams;

// The geometry of Quell's own planes: one plane holds one component of every pixel, with margins on all sides so
// that 16 pixels can be loaded from anywhere between column -16 and column width without leaving the buffer.
typedef struct PlaneParams {
  QuellInt width;   // pixels
  QuellInt height;  // pixels
  QuellInt pitch;   // elements from one row to the next
  QuellInt stride;  // elements from one plane to the next
} PlaneParams;

QUELL_NAMESPACE_END

// The largest finite half. Radiance is clamped to it when read: no square of it overflows a float, and half outputs
// never become infinite.
#define QUELL_MAX_RADIANCE 65504.0f

// Pixels of margin to the left and to the right of every row of a plane.
#define QUELL_PLANE_MARGIN 16
// Rows of margin above and below.
#define QUELL_PLANE_MARGIN_ROWS 2

#endif
