#include "host/metrics/report.hpp"

#include <cmath>

#include "host/metrics/display_encoding.hpp"
#include "host/metrics/error.hpp"
#include "host/metrics/flip.hpp"
#include "host/metrics/image_checks.hpp"

namespace quell::metrics {
namespace {

io::Image displayed(const io::Image& image, bool isEncoded) {
  return isEncoded ? clampEncoded(image) : encodeForDisplay(image);
}

bool applies(const Metric& metric, const Comparison& comparison) {
  if (metric.needs == Needs::BothHalves) return !comparison.halfB.empty();
  return metric.needs != Needs::LinearImage || !comparison.linear.empty();
}

std::optional<double> numberOrNothing(double value) {
  return std::isnan(value) ? std::nullopt : std::optional(value);
}

}  // namespace

ErrorFigures compareToReference(const io::Image& image, bool imageIsEncoded, const io::Image& referenceA,
                                const io::Image& referenceB, const DisplayTransform& transform) {
  requireComparable(image, referenceA, "compare");
  Comparison comparison;
  if (!imageIsEncoded) comparison.linear = image;
  comparison.shown = displayed(image, imageIsEncoded);
  comparison.referenceLinear = meanOfHalves(referenceA, referenceB);
  comparison.reference = encodeForDisplay(comparison.referenceLinear, transform);
  if (!referenceB.empty()) {
    comparison.halfA = encodeForDisplay(referenceA, transform);
    comparison.halfB = encodeForDisplay(referenceB, transform);
  }
  ErrorFigures figures;
  for (const Metric& metric : imageMetrics())
    figures.values.push_back(applies(metric, comparison) ? numberOrNothing(metric.measure(comparison))
                                                         : std::nullopt);
  return figures;
}

io::Image flipMapToReference(const io::Image& image, bool imageIsEncoded, const io::Image& referenceA,
                             const io::Image& referenceB) {
  requireComparable(image, referenceA, "compare");
  return flipMap(displayed(image, imageIsEncoded), encodeForDisplay(meanOfHalves(referenceA, referenceB)));
}

}  // namespace quell::metrics
