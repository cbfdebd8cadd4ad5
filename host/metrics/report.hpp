// All figures of one image against one reference, as the command line prints them.
#pragma once

#include <optional>

#include "host/io/image.hpp"

namespace quell::metrics {

/// Figures on display-encoded values unless said otherwise; definitions in error.hpp, ssim.hpp and flip.hpp.
struct ErrorFigures {
  double rmse = 0.0;                   ///< against the mean of the halves
  std::optional<double> unbiasedRmse;  ///< needs both halves; negative where the mean product is
  double psnr = 0.0;                   ///< dB; infinite for identical images
  double ssim = 0.0;                   ///< NaN for images smaller than 11x11
  double flip = 0.0;                   ///< mean of the FLIP map at 67 pixels per degree
  std::optional<double> relMse;        ///< on linear values; absent for an image that is encoded already
};

/// Compares `image` (3 channels, linear, or display-encoded if `imageIsEncoded`) with the reference's halves
/// A and B (3 channels, linear; B may be empty: then A alone is the reference). Encoded images are clamped to
/// [0, 1]. Throws Error(InvalidArgument) for other channel counts or sizes that differ.
ErrorFigures compareToReference(const io::Image& image, bool imageIsEncoded, const io::Image& referenceA,
                                const io::Image& referenceB);

/// The FLIP map (1 channel, [0, 1]) whose mean is ErrorFigures::flip; same arguments and errors.
io::Image flipMapToReference(const io::Image& image, bool imageIsEncoded, const io::Image& referenceA,
                             const io::Image& referenceB);

}  // namespace quell::metrics
