#include "tests/support/comparison.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <sstream>

namespace quell::tests {

void Comparison::include(const std::string& what, int plane, int x, int y, double device, double exact,
                         double scale) {
  if (m_ignored != nullptr && x >= 0 && m_ignored->at(0, x, y)) return;
  ++m_compared;
  double error = std::abs(device - exact) / std::max(scale, std::abs(exact));
  if (!std::isfinite(error)) error = std::numeric_limits<double>::infinity();
  if (error <= m_largestError) return;
  m_largestError = error;
  std::ostringstream text;
  text.precision(9);
  text << what << " plane " << plane << " at (" << x << ", " << y << "): device " << device << ", oracle "
       << exact << ", error " << error;
  m_worst = text.str();
}

void Comparison::include(const Comparison& other) {
  m_compared += other.m_compared;
  m_excluded += other.m_excluded;
  if (other.m_largestError <= m_largestError) return;
  m_largestError = other.m_largestError;
  m_worst = other.m_worst;
}

void comparePixels(Comparison& comparison, const std::string& what, const Planes& device,
                   const ExactPlanes& exact, const BasicPlanes<char>* excluded, const ExactPlanes* scales,
                   double unit) {
  forEachPixel(exact.size(), [&](int x, int y) {
    if (excluded != nullptr && excluded->at(0, x, y)) return;
    double scale = scales != nullptr ? std::max(unit, scales->at(0, x, y)) : unit;
    for (int plane = 0; plane < exact.count; ++plane)
      scale = std::max(scale, std::abs(exact.at(plane, x, y)));
    for (int plane = 0; plane < exact.count; ++plane)
      comparison.include(what, plane, x, y, device.at(plane, x, y), exact.at(plane, x, y), scale);
  });
}

bool sameBits(const Planes& a, const Planes& b, const BasicPlanes<char>* except) {
  if (a.values.size() != b.values.size()) return false;
  const std::size_t pixels = std::size_t(a.width) * std::size_t(a.height);
  for (std::size_t i = 0; i < a.values.size(); ++i) {
    if (except != nullptr && except->values[i % pixels]) continue;
    if (std::memcmp(&a.values[i], &b.values[i], sizeof(float)) != 0) return false;
  }
  return true;
}

bool allFinite(const Planes& planes) {
  return std::all_of(planes.values.begin(), planes.values.end(), [](float v) { return std::isfinite(v); });
}

}  // namespace quell::tests
