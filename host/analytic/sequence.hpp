// A built-in sequence of noisy frames: a small room at one sample per pixel, made up while it is read.
// For tests, for the bench and for a first try without any download.
#pragma once

#include <array>
#include <cstdint>
#include <memory>

#include "host/io/frame_sequence.hpp"

namespace quell::io {

/// What makeAnalyticSequence() shall make. World units are metres, z is up, right-handed.
struct AnalyticOptions {
  int width = 1280;     ///< pixels, in [1, 16384]
  int height = 720;     ///< pixels, in [1, 16384]
  int frameCount = 16;  ///< in [1, 2^20]
  std::uint32_t seed = 1;
  bool movingCamera = true;  ///< false: it stays at the pose of frame 0
  double skyShare = 0.0;     ///< in [0, 1]; this share of the rows, from the top, shows sky whatever is there
  std::array<double, 3> worldOffset{0.0, 0.0, 0.0};  ///< m, finite; moves scene and camera together
  int referenceSamples = 0;                          ///< per pixel and half, in [0, 2^20]; 0: no reference
  bool jitter = false;  ///< rays of frames leave the pixel centres, by io::jitterPxOf()
  int threadCount = 0;  ///< in [0, 1024]; 0: one per core. Never changes the pixels.
};

/// Makes the sequence. Equal options give equal pixels (on one build and machine; elsewhere up to the
/// rounding of floating point); frames may be read in any order.
///
/// Every frame has radiance, normal, position, albedo and emission; gloss colour stays empty. Rays go through
/// pixel centres, unless they are jittered. References are of both kinds, the antialiased one with a place of its own
/// inside the pixel for every sample. radiance = albedo * irradiance / pi + emission, albedo in [0, 1). The lamp and
/// the background have albedo zero and radiance = emission; the background (sky and sea) also has normal and
/// position zero. Positions are rounded to float after the offset is added.
/// The camera swings smoothly: at frame 0, where it is fastest, the image moves by about 3 (far side) to 8
/// (nearest floor) pixels per frame at 1280x720. The previous camera of frame 0 is the path's pose at frame
/// -1.
///
/// Throws Error(InvalidArgument) for an option outside its range; so do read() and reference() for a frame
/// outside [0, frameCount).
std::unique_ptr<FrameSequence> makeAnalyticSequence(const AnalyticOptions& options);

}  // namespace quell::io
