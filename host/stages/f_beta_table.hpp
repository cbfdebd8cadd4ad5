// The F_beta table: integrals of the BRDF over all incident directions, by which glossy signals are divided.
#pragma once

#include <vector>

#include "host/core/program_cache.hpp"

namespace quell {

/// Smith's masking-shadowing of the BRDF that is integrated. They differ by up to 0.39 at grazing angles.
enum class Shadowing {
  Separable,        ///< G1(o) G1(i)
  HeightCorrelated  ///< 1 / (1 + Lambda(o) + Lambda(i))
};

/// Built on the device or read from the disk cache when constructed, then only read. See
/// kernels/f_beta_table.cl for what is computed and after which paper, kernels/common/f_beta.h for lookups.
class FBetaTable {
 public:
  /// Enqueues on `queue` and waits. The disk cache is that of `programs`; an entry belongs to one device,
  /// driver and kernel source, so a hit gives the bits that would be computed. Throws Error(BuildFailed),
  /// Error(DeviceError), Error(OutOfMemory).
  FBetaTable(const cl::Context& context, const cl::Device& device, const cl::CommandQueue& queue,
             const DeviceTraits& traits, const ProgramCache& programs, Shadowing shadowing);

  /// For the kernel argument `__global const float4* table` of lookUpFBeta(); 1 MiB.
  const cl::Buffer& buffer() const { return m_buffer; }
  /// True if it was read from disk instead of computed.
  bool fromDisk() const { return m_fromDisk; }

  /// Scale and bias of each texel, interleaved, row by row: 2 * edge() * edge() values. Row y is roughness
  /// y / (edge() - 1), column x is cos(theta_o) = (x / (edge() - 1))^2. Waits for `queue`.
  std::vector<float> texels(const cl::CommandQueue& queue) const;
  static int edge();

 private:
  cl::Buffer m_buffer;
  bool m_fromDisk = false;
};

}  // namespace quell
