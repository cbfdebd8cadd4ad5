// The error measure of all stage tests, and where the largest error was.
#pragma once

#include <cstddef>
#include <string>

#include "tests/support/planes.hpp"

namespace quell::tests {

/// Collects |device - exact| / max(scale, |exact|). A device value that is not finite counts as an infinite
/// error. `scale` is the size of the terms that the value was summed from: rounding errors are relative to
/// that.
class Comparison {
 public:
  /// Pixels marked in `ignored` (1 plane) do not count.
  explicit Comparison(const BasicPlanes<char>* ignored = nullptr) : m_ignored(ignored) {}

  /// x < 0: of no pixel.
  void include(const std::string& what, int plane, int x, int y, double device, double exact,
               double scale = 1.0);
  /// Takes over the figures of another comparison.
  void include(const Comparison& other);
  /// A pixel on which float and double may decide differently: within rounding of a threshold.
  void exclude() { ++m_excluded; }
  /// All pixels that are marked.
  void exclude(const BasicPlanes<char>& marks) {
    for (const char mark : marks.values)
      if (mark) exclude();
  }

  double largestError() const { return m_largestError; }
  std::size_t compared() const { return m_compared; }
  std::size_t excluded() const { return m_excluded; }
  /// What, where and both values.
  const std::string& worst() const { return m_worst; }

 private:
  const BasicPlanes<char>* m_ignored;
  double m_largestError = 0.0;
  std::size_t m_compared = 0;
  std::size_t m_excluded = 0;
  std::string m_worst = "no error";
};

/// Compares all values, the scale of a pixel being the largest magnitude of its components, at least `unit` and at
/// least what `scales` says (1 plane). The unit is the size of what the values were made from, neighbours included: 1
/// for directions, weights and encoded colours.
void comparePixels(Comparison& comparison, const std::string& what, const Planes& device,
                   const ExactPlanes& exact, const BasicPlanes<char>* excluded = nullptr,
                   const ExactPlanes* scales = nullptr, double unit = 1.0);

/// True if both have the same bits everywhere, `except` apart (pixels that are true there may differ).
bool sameBits(const Planes& a, const Planes& b, const BasicPlanes<char>* except = nullptr);

/// True if no value is NaN or Inf.
bool allFinite(const Planes& planes);

}  // namespace quell::tests
