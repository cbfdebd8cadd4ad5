// Double-precision oracle of common/demodulation.h and common/material.h: the signals of a pixel, irradiance =
// (radiance - emission) / material factor, and the share of every channel that is filtered.
#pragma once

#include <Eigen/Core>

#include "host/io/image.hpp"
#include "tests/support/planes.hpp"

namespace quell::tests {

using Eigen::Vector3d;

/// The caller's images of one frame; an empty one is absent.
struct MaterialImages {
  io::Image radiance, emission, albedo, glossColor;
  bool demodulated = false;  ///< radiance is irradiance already
  io::Image glossyRadiance;  ///< makes two signals of them
  bool divide = true;        ///< false: light is filtered as it is
  io::Image f0;              ///< empty: absent
  /// 3 planes: what the gloss colour is multiplied by, as the device looked it up; empty: by nothing. Not with
  /// `demodulated`.
  Planes fBeta;

  int signals() const { return glossyRadiance.empty() ? 1 : 2; }
};

/// One signal of one pixel of them, cleaned.
struct Material {
  bool finite = true;                    ///< neither light nor emission is NaN or Inf
  Vector3d signal = Vector3d::Zero();    ///< light without emission, [0, 65504]
  Vector3d emission = Vector3d::Zero();  ///< of the first signal; 0 where it is not finite
  Vector3d factor = Vector3d::Ones();    ///< what filters see the signal divided by, >= 0
  Vector3d tint = Vector3d::Ones();      ///< what the result is multiplied by once more, >= 0
};
/// One signal: albedo plus gloss colour tint it. Two: albedo tints the first, gloss colour the second.
Material materialAt(const MaterialImages& images, int x, int y, int signal = 0);

/// Three components of a pixel: one channel is spread, a missing third is 0.
Vector3d rgbAt(const io::Image& image, int x, int y);

/// smoothstep(0, 0.01, factor), 0 below the least factor.
Vector3d filteredShare(const Vector3d& factor);

/// Irradiance of a pixel and its weight as a filter tap.
struct Irradiance {
  Vector3d value;
  double weight;
};
Irradiance demodulate(const Material& material);

/// True where a factor lies so near the least factor that float and double may disagree about its side.
bool factorUndecided(const Material& material);

}  // namespace quell::tests
