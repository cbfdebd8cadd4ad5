// Double-precision oracle of common/demodulation.h, common/material.h and common/emitters.h: the signals of a pixel,
// irradiance = (radiance - emission) / material factor within bounds, and what is not filtered.
#pragma once

#include <Eigen/Core>
#include <array>

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
  Vector3d emission = Vector3d::Zero();  ///< of the first signal, as far as its light has it
  Vector3d divisor = Vector3d::Ones();   ///< what filters see the signal divided by, > 0
  Vector3d tint = Vector3d::Ones();      ///< what the result is multiplied by once more, >= 0
  std::array<bool, 3> weak{};            ///< channels whose factor vanishes
  bool fillsWeak = false;                ///< weak channels pass through, and are grey to filters
  bool emits = false;                    ///< an emitter's: passes through
  bool faint = false;                    ///< passes through until there is a history
  bool undecided = false;                ///< float and double may disagree about the four above

  bool vanishes() const { return weak[0] && weak[1] && weak[2]; }
  bool passesThrough(bool hasHistory) const { return finite && (emits || (faint && !hasHistory)); }
  Vector3d irradiance() const;
};
/// One signal: albedo plus gloss colour tint it. Two: albedo tints the first, gloss colour the second.
Material materialAt(const MaterialImages& images, int x, int y, int signal = 0);

/// Three components of a pixel: one channel is spread, a missing third is 0.
Vector3d rgbAt(const io::Image& image, int x, int y);

}  // namespace quell::tests
