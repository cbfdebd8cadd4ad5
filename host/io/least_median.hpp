// Least median of squares (Rousseeuw 1984): fits that up to half of the samples may spoil.
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <random>
#include <vector>

namespace quell::io {

/// The middle of the sorted values, of an even number the upper one; there is one at least.
inline double middleValue(std::vector<double> values) {
  const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Samples of a subset, and subsets. With a third of the samples broken, 3 subsets are free of them on average.
constexpr std::size_t kSubset = 8, kSubsets = 64;

/// What fits a few samples and is least off for half of all. `fit` gives an optional model of samples, `medianOf` how far a
/// model is off. The same samples give the same model.
template <class Sample, class Fit, class MedianOf>
auto leastMedian(const std::vector<Sample>& samples, const Fit& fit, const MedianOf& medianOf) {
  std::minstd_rand random;
  decltype(fit(samples)) best;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < kSubsets; ++i) {
    std::vector<Sample> subset;
    while (subset.size() < kSubset) subset.push_back(samples[random() % samples.size()]);
    const auto model = fit(subset);
    if (!model) continue;
    const double median = medianOf(*model);
    if (best && !(median < least)) continue;
    best = model;
    least = median;
  }
  return best;
}

}  // namespace quell::io
