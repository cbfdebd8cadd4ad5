#include "tests/oracle/follow_change_oracle.hpp"

#include <algorithm>
#include <cmath>

#include "tests/oracle/edge_stops_oracle.hpp"

namespace quell::tests {
namespace {

// Error of an interpolated weight and of the inverse of it, up to 255 frames, in float.
constexpr double kWeightRounding = 1e-6;
constexpr double kLengthRounding = 1e-4;

// What a blend of history and newest value would be with another weight of the latter.
double reblend(double blended, double newest, double given, double wanted) {
  if (given >= wanted) return blended;
  const double history = (blended - given * newest) / (1.0 - given);
  return (1.0 - wanted) * history + wanted * newest;
}

void followSignal(const FollowChangeInputs& inputs, FollowChangeExact& exact, int signal, int x, int y) {
  const double length = inputs.historyLength.at(signal, x, y);
  const double cumulative = 1.0 / std::max(length, 1.0);
  const double given = std::max(cumulative, inputs.leastWeight);
  const double wanted = betweenTiles(inputs.weights, TileGrid(inputs.historyLength.size()), signal, x, y);
  char& undecided = exact.undecided.at(0, x, y);
  undecided = char(undecided || std::abs(wanted - given) < kWeightRounding);
  if (wanted <= given || inputs.newestIrradiance.at(3 * signal, x, y) < 0.0f) return;
  exact.touched.at(signal, x, y) = 1;
  double newest[3];
  for (int c = 0; c < 3; ++c) {
    newest[c] = inputs.newestIrradiance.at(3 * signal + c, x, y);
    double& value = exact.irradiance.at(3 * signal + c, x, y);
    value = reblend(value, newest[c], given, wanted);
  }
  const double luminance = luminanceOf(newest[0], newest[1], newest[2]);
  for (int i = 0; i < QUELL_MOMENT_PLANES; ++i) {
    double& moment = exact.moments.at(QUELL_MOMENT_PLANES * signal + i, x, y);
    moment =
        reblend(moment, std::pow(luminance, i + 1), std::max(cumulative, inputs.momentsLeastWeight), wanted);
  }
  const double worth = 1.0 / wanted;
  undecided = char(undecided || std::abs(worth - std::floor(worth) - 0.5) < kLengthRounding);
  exact.historyLength.at(signal, x, y) = std::floor(worth + 0.5);
}

ExactPlanes toExact(const Planes& planes) {
  ExactPlanes exact(planes.size(), planes.count);
  std::copy(planes.values.begin(), planes.values.end(), exact.values.begin());
  return exact;
}

}  // namespace

FollowChangeExact followChangeOracle(const FollowChangeInputs& inputs) {
  const Size size = inputs.historyLength.size();
  FollowChangeExact exact{toExact(inputs.irradiance), toExact(inputs.moments), toExact(inputs.historyLength),
                          BasicPlanes<char>(size, inputs.signals()), BasicPlanes<char>(size, 1)};
  for (int signal = 0; signal < inputs.signals(); ++signal)
    forEachPixel(size, [&](int x, int y) { followSignal(inputs, exact, signal, x, y); });
  return exact;
}

}  // namespace quell::tests
