// LDR-FLIP: the difference a person sees when two images alternate in place.
//
// P. Andersson, J. Nilsson, T. Akenine-Moller, M. Oskarsson, K. Astrom, M. D. Fairchild, "FLIP: A Difference
// Evaluator for Alternating Images", Proceedings of the ACM on Computer Graphics and Interactive Techniques
// 3(2), 2020. Departure: the paper's default viewing condition is 67.02 pixels per degree, here 67 (this
// project's definition).
#pragma once

#include "host/io/image.hpp"

namespace quell::metrics {

/// Viewing condition, pixels per degree of visual angle: a 0.7 m wide display of 3840 pixels seen from 0.7 m.
constexpr double kFlipPixelsPerDegree = 67.0;

/// The FLIP map: 1 channel in [0, 1], 0 where no difference is visible. Inputs have 3 channels and are
/// display-encoded in [0, 1] (values outside are clamped), taken for sRGB. Beyond its border an image repeats
/// its nearest pixel. Throws Error(InvalidArgument): images without 3 channels or of different sizes, or a
/// pixelsPerDegree outside (0, 1000].
io::Image flipMap(const io::Image& imageEncoded, const io::Image& referenceEncoded,
                  double pixelsPerDegree = kFlipPixelsPerDegree);

/// Mean of a map's values.
double meanOfMap(const io::Image& map);

/// Mean of the FLIP map.
double flip(const io::Image& imageEncoded, const io::Image& referenceEncoded,
            double pixelsPerDegree = kFlipPixelsPerDegree);

}  // namespace quell::metrics
