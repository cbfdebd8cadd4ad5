// The error figures of an image: what each is called, how it reads, and how it is measured. Everything that shows
// figures (text, JSON, CSV, the page of `quell bench`, comparisons, `quell tune`) follows this table.
#pragma once

#include <string_view>
#include <vector>

#include "host/io/image.hpp"

namespace quell::metrics {

/// An image and its reference in the forms that metrics take, 3 channels each.
struct Comparison {
  io::Image linear;           ///< the image; empty if it came display-encoded
  io::Image shown;            ///< display-encoded
  io::Image referenceLinear;  ///< mean of the halves
  io::Image reference;        ///< display-encoded
  io::Image halfA, halfB;     ///< of the reference, display-encoded; empty where there is but one
};

/// What a metric needs besides the display-encoded image and reference.
enum class Needs { Nothing, LinearImage, BothHalves };

/// What `quell tune` does with a metric: nothing, show it, or look for settings that make it small.
enum class Tuning { None, Shown, Minimised };

struct Metric {
  const char* key;     ///< in JSON and CSV
  const char* label;   ///< in text
  const char* column;  ///< the label where there is little room
  const char* unit;    ///< may be empty
  double best;         ///< of equal images: 0, and less is better; or 1 or infinity, and more is better
  int digits;          ///< behind the point
  int fineDigits;      ///< the same where there is room for more
  int fineWidth;       ///< characters of a value with `fineDigits`
  bool compared;       ///< whether `quell bench --compare` reports its changes
  Tuning tuning;
  bool meanOfSquares;   ///< over frames: the root of the mean of squares, signs kept; else the plain mean
  const char* standIn;  ///< key of the metric that takes its place where it cannot be had, or null
  Needs needs;
  /// Null for what is measured over a sequence. NaN where there is no value, as for too small an image.
  double (*measure)(const Comparison& comparison);

  bool higherIsBetter() const { return best > 0.0; }
};

/// Those of single images, in the order of all reports.
const std::vector<Metric>& imageMetrics();

/// The first one to look at.
const Metric& headlineMetric();

/// Of a sequence: see MotionCompensatedErrorMeter.
extern const Metric kTemporalError;

/// Place in imageMetrics(). Throws Error(InvalidArgument) for an unknown key.
std::size_t indexOfMetric(std::string_view key);

}  // namespace quell::metrics
