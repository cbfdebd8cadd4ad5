#include "host/check/reference_checks.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace quell::check {
namespace {

/// Mean light of a frame as a multiple of its reference's: one sample per pixel is off by a few percent.
constexpr double kMostTimes = 1.5;

std::size_t valuesOf(const Image& image) {
  return std::size_t(image.width) * std::size_t(image.height) * std::size_t(image.channels);
}

double meanOf(const Image& image) {
  double sum = 0.0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < valuesOf(image); ++i) {
    if (!std::isfinite(image.values[i])) continue;
    sum += double(image.values[i]);
    ++count;
  }
  return sum / double(count);
}

void identicalHalves(const Image& a, const Image& b, std::vector<Finding>& findings) {
  if (!b.present() || !std::equal(a.values, a.values + valuesOf(a), b.values)) return;
  findings.push_back({"reference-halves-identical", Severity::Wrong, "reference",
                      "two halves with noise of their own", "one picture twice",
                      "render the second half with another seed, or leave it out; errors now count "
                      "the reference's noise as the denoiser's",
                      std::size_t(a.width) * std::size_t(a.height)});
}

void brokenPixels(const Image& image, const char* half, std::vector<Finding>& findings) {
  std::size_t broken = 0;
  if (image.present())
    for (int y = 0; y < image.height; ++y)
      for (int x = 0; x < image.width; ++x) broken += !isFinite(vectorAt(image, x, y));
  if (broken > 0)
    findings.push_back({"reference-broken", Severity::Wrong, "reference", "finite light",
                        std::string("NaN or infinite in half ") + half,
                        "error figures are not finite either; render the reference without them", broken});
}

void brightness(const Image& noisy, const Image& a, std::vector<Finding>& findings) {
  const double times = meanOf(noisy) / meanOf(a);
  if (!(times > kMostTimes || times < 1.0 / kMostTimes)) return;
  const bool sum = std::abs(times - std::round(times)) < 0.1 * times && times > kMostTimes;
  findings.push_back({"brightness-differs", Severity::Doubtful, "radiance",
                      "light as bright as its reference's on average", fixed(times, 2) + " times as bright",
                      sum ? "divide by the number of samples if they were summed up, or by the exposure"
                          : "give both the same exposure, and both or none the tone map",
                      0});
}

}  // namespace

std::vector<Finding> checkReference(const Image& noisy, const Image& a, const Image& b) {
  std::vector<Finding> findings;
  identicalHalves(a, b, findings);
  brokenPixels(a, "A", findings);
  brokenPixels(b, "B", findings);
  brightness(noisy, a, findings);
  return findings;
}

}  // namespace quell::check
