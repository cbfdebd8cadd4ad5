// One-sample lighting of the built-in test scene: what a path tracer with two segments per pixel would find.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>

#include "host/analytic/scene.hpp"

namespace quell::io::analytic {

/// Random numbers from a key: equal keys give equal series on every machine and in every thread.
/// Generator: PCG-XSH-RR 64/32 (O'Neill 2014), its state spread by the SplitMix64 finaliser (Steele 2014).
class Random {
 public:
  /// The series for sample `sample` of pixel number `pixel` in one frame of one stream (noisy, half a, half
  /// b).
  Random(std::uint32_t seed, std::uint32_t stream, std::uint32_t frame, std::uint32_t pixel,
         std::uint32_t sample);

  /// Uniform in [0, 1).
  double uniform();

 private:
  std::uint64_t m_state;
};

/// One noisy sample of irradiance / pi at a hit, linear RGB, >= 0: light from the lamp or the sun (one of
/// them, picked at random, with its shadow), plus what one cosine-distributed ray brings: sky, or a surface
/// lit in the same way and by a constant. Its mean is the scene's lighting; times albedo it is radiance.
/// `shadingNormal`: unit length, within 90 degrees of the hit's own normal.
glm::dvec3 sampleIrradiance(const Hit& hit, const glm::dvec3& shadingNormal, Random& random);

}  // namespace quell::io::analytic
