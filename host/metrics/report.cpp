#include "host/metrics/report.hpp"

#include <limits>

#include "host/metrics/display_encoding.hpp"
#include "host/metrics/error.hpp"
#include "host/metrics/flip.hpp"
#include "host/metrics/image_checks.hpp"
#include "host/metrics/ssim.hpp"

namespace quell::metrics {
namespace {

io::Image displayed(const io::Image& image, bool isEncoded) {
  return isEncoded ? clampEncoded(image) : encodeForDisplay(image);
}

}  // namespace

ErrorFigures compareToReference(const io::Image& image, bool imageIsEncoded, const io::Image& referenceA,
                                const io::Image& referenceB) {
  requireComparable(image, referenceA, "compare");
  const io::Image referenceLinear = meanOfHalves(referenceA, referenceB);
  const io::Image reference = encodeForDisplay(referenceLinear);
  const io::Image shown = displayed(image, imageIsEncoded);

  ErrorFigures figures;
  figures.rmse = rmse(shown, reference);
  if (!referenceB.empty())
    figures.unbiasedRmse = unbiasedRmse(shown, encodeForDisplay(referenceA), encodeForDisplay(referenceB));
  figures.psnr = psnr(shown, reference);
  figures.ssim =
      isLargeEnoughForSsim(shown) ? ssim(shown, reference) : std::numeric_limits<double>::quiet_NaN();
  figures.flip = flip(shown, reference);
  if (!imageIsEncoded) figures.relMse = relMse(image, referenceLinear);
  return figures;
}

io::Image flipMapToReference(const io::Image& image, bool imageIsEncoded, const io::Image& referenceA,
                             const io::Image& referenceB) {
  requireComparable(image, referenceA, "compare");
  return flipMap(displayed(image, imageIsEncoded), encodeForDisplay(meanOfHalves(referenceA, referenceB)));
}

}  // namespace quell::metrics
