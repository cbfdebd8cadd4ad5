// Structural similarity. Z. Wang, A. C. Bovik, H. R. Sheikh, E. P. Simoncelli, "Image Quality Assessment:
// From Error Visibility to Structural Similarity", IEEE Transactions on Image Processing 13(4), 2004.
#pragma once

#include "host/io/image.hpp"

namespace quell::metrics {

constexpr int kSsimWindowPx = 11;     ///< side of the window, pixels
constexpr double kSsimSigmaPx = 1.5;  ///< of the window's circular Gaussian, pixels
constexpr double kSsimK1 = 0.01;      ///< stabilises the luminance term; of the dynamic range
constexpr double kSsimK2 = 0.03;      ///< stabilises the contrast term; of the dynamic range
constexpr double kSsimRange = 1.0;    ///< L, the dynamic range of encoded values

/// Whether the image has room for one whole window.
bool isLargeEnoughForSsim(const io::Image& image);

/// Mean over all windows that lie inside the image of the SSIM index of Rec. 709 luma, in [-1, 1]; 1 if
/// identical. Both images display-encoded, 3 channels. Throws Error(InvalidArgument): different sizes, or
/// smaller than 11x11.
double ssim(const io::Image& imageEncoded, const io::Image& referenceEncoded);

}  // namespace quell::metrics
