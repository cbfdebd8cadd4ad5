// All figures of one image against one reference, as the command line prints them.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "host/core/display_transform.hpp"
#include "host/metrics/metric_table.hpp"

namespace quell::metrics {

/// The figures of one image, in the order of imageMetrics(); nothing where a metric does not apply or
/// has no value: of pixels that are not numbers, or of images too small for it.
struct ErrorFigures {
  std::vector<std::optional<double>> values;

  /// By a metric's key. Throws Error(InvalidArgument) for an unknown one.
  const std::optional<double>& at(std::string_view key) const { return values[indexOfMetric(key)]; }
};

/// Compares `image` (3 channels, linear, or display-encoded if `imageIsEncoded`) with the reference's halves
/// A and B (3 channels, linear; B may be empty: then A alone is the reference). Encoded images are clamped to
/// [0, 1]; `transform` is what they were encoded with. Throws Error(InvalidArgument) for other channel counts or sizes
/// that differ.
ErrorFigures compareToReference(const io::Image& image, bool imageIsEncoded, const io::Image& referenceA,
                                const io::Image& referenceB, const DisplayTransform& transform = {});

/// The FLIP map (1 channel, [0, 1]) whose mean is the metric `flip`; same arguments and errors.
io::Image flipMapToReference(const io::Image& image, bool imageIsEncoded, const io::Image& referenceA,
                             const io::Image& referenceB);

}  // namespace quell::metrics
