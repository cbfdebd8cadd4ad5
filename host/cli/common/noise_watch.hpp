// Noise that stays the same from frame to frame, as renderers leave it that start every frame from the same seed.
#pragma once

#include <optional>
#include <vector>

#include "host/io/frame_sequence.hpp"

namespace quell::cli {

/// Correlates how far pixels are from the mean of their neighbours with the same of the frame before.
class NoiseWatch {
 public:
  struct Result {
    bool frozen = false;       ///< one of the first pairs of frames had the same noise
    double correlation = 0.0;  ///< of the latest pair that was looked at
    bool repeats = false;  ///< frozen, and surfaces are where they were: the frame brings no further samples
  };

  /// Frames in order; what does not follow the one before starts anew. Looks at the first pairs alone. Nothing is found
  /// without albedo or gloss colour, since texture would look like noise, nor where there is hardly any noise.
  Result add(const io::FrameData& frame);

 private:
  void compare(const io::FrameData& frame);

  std::vector<double> m_last;  ///< residuals of the frame before; NaN where there is none
  std::optional<int> m_lastNumber;
  int m_pairs = 0;
  Result m_result;
};

}  // namespace quell::cli
