// The noise of a frame, and whether it is that of another.
#pragma once

#include <optional>
#include <vector>

#include "host/check/frame.hpp"

namespace quell::check {

/// How far pixels of a regular grid are from the mean of their neighbours that show the same surface, as a share of it, in
/// [-1, 1]; NaN where too few do. Of light without texture: nothing but NaN without albedo or gloss colour.
std::vector<double> noiseResiduals(const Frame& frame);

/// Of the residuals of two frames of one size. Nothing if there are too few pixels, or no noise to speak of.
std::optional<double> noiseCorrelation(const std::vector<double>& a, const std::vector<double>& b);

/// Correlation from which on noise is the same. Measured: at most 0.13 for seeds of their own (480x270 path-traced with one
/// sample; texture and shadows), 0.81 and more for one seed, under a moving camera, too.
constexpr double kFrozenNoise = 0.5;

/// Kind of the finding.
constexpr char kFrozenNoiseKind[] = "noise-frozen";

/// Whether most surfaces are where the matrices say that they were before.
bool isStill(const Frame& frame);

}  // namespace quell::check
