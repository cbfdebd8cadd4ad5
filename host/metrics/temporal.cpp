#include "host/metrics/temporal.hpp"

#include <cmath>
#include <quell/error.hpp>
#include <string>

#include "host/metrics/display_encoding.hpp"
#include "host/metrics/image_checks.hpp"

namespace quell::metrics {

double meanLumaDifference(const io::Image& aEncoded, const io::Image& bEncoded) {
  requireComparable(bEncoded, aEncoded, "temporal error");
  const auto lumaAt = [](const io::Image& image, std::size_t i) {
    return luma(double(image.pixels[i]), double(image.pixels[i + 1]), double(image.pixels[i + 2]));
  };
  double sum = 0.0;
  for (std::size_t i = 0; i < aEncoded.pixels.size(); i += kRgbChannels)
    sum += std::abs(lumaAt(aEncoded, i) - lumaAt(bEncoded, i));
  return sum / double(aEncoded.pixels.size() / kRgbChannels);
}

void TemporalErrorMeter::add(const io::Image& frameEncoded) {
  if (!m_last.empty()) {
    m_sum += meanLumaDifference(m_last, frameEncoded);
    ++m_pairCount;
  }
  m_last = frameEncoded;
}

std::optional<double> TemporalErrorMeter::mean() const {
  if (m_pairCount == 0) return std::nullopt;
  return m_sum / m_pairCount;
}

double temporalError(const std::vector<io::Image>& framesEncoded) {
  TemporalErrorMeter meter;
  for (const io::Image& frame : framesEncoded) meter.add(frame);
  if (const auto mean = meter.mean()) return *mean;
  throw Error(ErrorCode::InvalidArgument,
              {"temporal error", "frames", "at least two frames", std::to_string(framesEncoded.size())});
}

}  // namespace quell::metrics
