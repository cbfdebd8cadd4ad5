// The buffer contract: what a renderer hands over for one frame and what it gets back.
#pragma once

#include <quell/camera.hpp>
#include <quell/image_view.hpp>

namespace quell {

/// Inputs of one frame, in device memory that the caller owns; read until the event of denoise() has
/// completed.
///
/// A pixel with NaN or Inf in radiance or emission is a missing sample: it keeps its history or is filled
/// from its surroundings. A pixel whose position or normal is not finite passes through unfiltered.
struct Frame {
  Size size;
  Camera camera;

  /// Linear radiance with emission included, 1, 3 or 4 channels (one is spread to RGB, a fourth ignored), one
  /// sample per pixel or more. Radiance minus emission is clamped to [0, 65504].
  ImageView radiance;
  /// Glossy radiance, layouts and values as radiance; optional. With it, two signals are filtered side by side:
  /// radiance is then the diffuse part alone (with emission), and the output is the sum of both.
  ImageView glossyRadiance;
  /// Shading normal, world space, unit length (0.5 to 2 is tolerated), 3 or 4 channels. A zero normal marks
  /// background, which passes through unfiltered.
  ImageView normalWorld;
  /// World-space position, scene units, 3 or 4 channels. Half is accepted only while the camera is within
  /// kHalfPositionRange of the world origin on every axis. Either this or viewDepth.
  ImageView positionWorld;
  /// Depth along the view axis, scene units, positive in front of the camera, 1 channel; perspective cameras
  /// only.
  ImageView viewDepth;
  /// Diffuse albedo, reflectance 0 to 1; optional.
  ImageView albedo;
  /// Tint of the glossy lobe, reflectance 0 to 1, optional. With one signal irradiance is (radiance -
  /// emission) / (albedo + gloss colour), with two (radiance - emission) / albedo and glossyRadiance / gloss
  /// colour; a factor that is not given is 1.
  ImageView glossColor;
  /// Roughness of the glossy lobe, 0 (mirror) to 1, 1 channel, optional; the alpha of GGX is its square. Read by
  /// edge stops (setting `roughnessSigma`) and by features that are made of it (setting `features` of bmfr).
  ImageView roughness;
  /// Fresnel reflectance at normal incidence, 0 to 1; optional, 1 where absent. Read where light is divided by
  /// F_beta (setting `demodulate`).
  ImageView f0;
  /// Motion vectors: where this pixel's surface point was in the frame before, minus this pixel; pixels, x right, y
  /// down, without jitter (0 for a scene and a camera at rest), 2 to 4 channels (the first two are read); optional.
  /// Where given they win over the matrices, for the background, too, and objects that move keep their history. A
  /// vector that is not finite or leads out of the frame before: no history for this pixel.
  ImageView motion;
  /// Which object a pixel shows, 1 channel, any number; optional. Compared bit by bit: 32-bit unsigned, or floats (whole
  /// numbers are exact up to 2^24, halves up to 2^11). History of another object is discarded.
  ImageView objectId;
  /// Emitted radiance and visible sky, linear, added back unfiltered; optional.
  ImageView emission;
  /// True where radiance is irradiance already: divided by albedo (glossyRadiance: by gloss colour), emission
  /// not included.
  bool demodulated = false;
};

/// Half has a spacing of 1/64 scene units here; beyond, positions are too coarse to tell surfaces apart.
constexpr double kHalfPositionRange = 32.0;

/// Outputs of one frame, either or both; 3 or 4 channels (a fourth becomes 1). Every pixel is written, always
/// finite. `linear` may be the radiance image itself in the same layout; no other overlap with an input.
struct Output {
  ImageView linear;   ///< linear radiance before tone map and TAA, 0 to 65504
  ImageView display;  ///< display-encoded (gamma 2.2) after TAA, 0 to 1
};

}  // namespace quell
