// Flicker between consecutive frames.
#pragma once

#include <optional>
#include <vector>

#include "host/io/image.hpp"

namespace quell::metrics {

/// Mean over pixels of |luma(a) - luma(b)|, Rec. 709, both display-encoded; in [0, 1].
/// Throws Error(InvalidArgument) for images without 3 channels or of different sizes.
double meanLumaDifference(const io::Image& aEncoded, const io::Image& bEncoded);

/// Temporal error: the mean of meanLumaDifference() over consecutive frames. It measures flicker only while
/// view, objects and lights stand still; with motion it also counts what truly changed. Takes frames one at a
/// time and keeps the last one only.
class TemporalErrorMeter {
 public:
  /// Throws Error(InvalidArgument) for a frame without 3 channels or of another size than the one before.
  void add(const io::Image& frameEncoded);

  /// Nothing before the second frame.
  std::optional<double> mean() const;

 private:
  io::Image m_last;
  double m_sum = 0.0;
  int m_pairCount = 0;
};

/// The temporal error of frames in memory. Throws Error(InvalidArgument) for fewer than two frames.
double temporalError(const std::vector<io::Image>& framesEncoded);

}  // namespace quell::metrics
