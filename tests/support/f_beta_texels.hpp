// The F_beta table in host memory, and where its texels lie.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "host/stages/f_beta_table.hpp"
#include "kernels/f_beta_table_params.h"
#include "tests/oracle/f_beta_oracle.hpp"
#include "tests/support/stage_harness.hpp"

namespace quell::tests {

constexpr int kFBetaEdge = QUELL_F_BETA_EDGE;

inline double texelCosTheta(int x) { return std::pow(x / double(kFBetaEdge - 1), 2.0); }
inline double texelRoughness(int y) { return y / double(kFBetaEdge - 1); }

/// Larger of the two absolute differences; infinite if a value is not finite.
inline double largestDifference(const FBetaTerms& a, const FBetaTerms& b) {
  const double difference = std::max(std::abs(a.scale - b.scale), std::abs(a.bias - b.bias));
  const bool finite = std::isfinite(a.scale + a.bias) && std::isfinite(b.scale + b.bias);
  return finite ? difference : std::numeric_limits<double>::infinity();
}

/// The oracle for any point of the table's range, limits included: roughness 0 is a mirror, and grazing angles
/// are approached to 1e-9, far below the smallest alpha of a texel (1.5e-5).
inline FBetaTerms exactFBeta(double cosTheta, double roughness, Shadowing shadowing,
                             int order = kFBetaOracleOrder) {
  if (roughness == 0.0) {
    const double fresnel = std::pow(1.0 - cosTheta, 5.0);
    return {1.0 - fresnel, fresnel};
  }
  return fBetaOracle({roughness, shadowing == Shadowing::HeightCorrelated}, std::max(cosTheta, 1e-9), order);
}

inline FBetaTerms exactTexel(int x, int y, Shadowing shadowing, int order = kFBetaOracleOrder) {
  return exactFBeta(texelCosTheta(x), texelRoughness(y), shadowing, order);
}

/// A table made on the tests' device, `directory` as for ProgramCache.
class FBetaTexels {
 public:
  FBetaTexels(Mapping mapping, Shadowing shadowing, const std::string& directory = "")
      : m_table(TestDevice::shared().context, TestDevice::shared().device, TestDevice::shared().queue,
                queryDeviceTraits(TestDevice::shared().device, mapping), ProgramCache(directory), shadowing),
        m_values(m_table.texels(TestDevice::shared().queue)) {}

  FBetaTerms at(int x, int y) const {
    const std::size_t i = 2 * (std::size_t(y) * std::size_t(kFBetaEdge) + std::size_t(x));
    return {m_values[i], m_values[i + 1]};
  }
  const std::vector<float>& values() const { return m_values; }
  bool fromDisk() const { return m_table.fromDisk(); }
  const cl::Buffer& buffer() const { return m_table.buffer(); }

 private:
  FBetaTable m_table;
  std::vector<float> m_values;
};

/// One table for all tests of a process: with one lane it takes seconds on a CPU.
inline const FBetaTexels& sharedFBetaTexels(Mapping mapping, Shadowing shadowing) {
  static std::map<std::pair<Mapping, Shadowing>, FBetaTexels> tables;
  return tables.try_emplace({mapping, shadowing}, mapping, shadowing).first->second;
}

}  // namespace quell::tests
