#include "tests/oracle/f_beta_oracle.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

namespace quell::tests {
namespace {

constexpr double kPi = 3.141592653589793;

struct Node {
  double at, weight;
};

// Gauss-Legendre on [0, 1], nodes by Newton's method on the Legendre polynomial.
std::vector<Node> gaussLegendre(int order) {
  std::vector<Node> nodes;
  for (int i = 0; i < order; ++i) {
    double z = std::cos(kPi * (i + 0.75) / (order + 0.5)), slope = 0.0;
    for (int iteration = 0; iteration < 50; ++iteration) {
      double p = 1.0, previous = 0.0;
      for (int j = 0; j < order; ++j) {
        const double next = ((2 * j + 1) * z * p - j * previous) / (j + 1);
        previous = p;
        p = next;
      }
      slope = order * (z * p - previous) / (z * z - 1.0);
      z -= p / slope;
    }
    nodes.push_back({0.5 - 0.5 * z, 1.0 / ((1.0 - z * z) * slope * slope)});
  }
  return nodes;
}

// The same after t -> t^3 (10 - 15 t + 6 t^2), which flattens roots and kinks at the ends.
const std::vector<Node>& smoothedNodes(int order) {
  static std::map<int, std::vector<Node>> kept;
  std::vector<Node>& nodes = kept[order];
  if (!nodes.empty()) return nodes;
  nodes = gaussLegendre(order);
  for (Node& node : nodes) {
    const double t = node.at;
    node.weight *= 30.0 * t * t * (1.0 - t) * (1.0 - t);
    node.at = t * t * t * (10.0 + t * (-15.0 + 6.0 * t));
  }
  return nodes;
}

double smithLambda(double alpha, double cosTheta) {
  const double tanSquared = (1.0 - cosTheta * cosTheta) / (cosTheta * cosTheta);
  return 0.5 * (std::sqrt(1.0 + alpha * alpha * tanSquared) - 1.0);
}

double maskingShadowing(const GgxSurface& surface, double cosOut, double cosIn) {
  const double alpha = surface.roughness * surface.roughness;
  const double out = smithLambda(alpha, cosOut), in = smithLambda(alpha, cosIn);
  return surface.correlated ? 1.0 / (1.0 + out + in) : 1.0 / ((1.0 + out) * (1.0 + in));
}

void add(FBetaTerms& sum, double value, double cosHalf) {
  const double m = 1.0 - std::min(cosHalf, 1.0), schlick = m * m * m * m * m;
  sum.scale += value * (1.0 - schlick);
  sum.bias += value * schlick;
}

// Mean over the azimuth of half vectors at `theta` from the normal.
FBetaTerms azimuthMean(const GgxSurface& surface, double cosOut, double theta,
                       const std::vector<Node>& nodes) {
  const double sines = std::sqrt(1.0 - cosOut * cosOut) * std::sin(theta), cosH = std::cos(theta);
  // cos(phi) at which the incident direction is on the horizon: 2 (o.h) cosH = cosOut.
  const double horizon = cosOut * (0.5 / cosH - cosH);
  FBetaTerms mean;
  if (horizon >= sines) return mean;
  const double limit = horizon > -sines ? std::acos(horizon / sines) : kPi;
  for (const Node& node : nodes) {
    const double cosHalf = sines * std::cos(limit * node.at) + cosOut * cosH;
    const double cosIn = std::min(2.0 * cosHalf * cosH - cosOut, 1.0);
    if (cosIn <= 0.0) continue;
    const double value = maskingShadowing(surface, cosOut, cosIn) * cosHalf / (cosOut * cosH);
    add(mean, value * node.weight * limit / kPi, cosHalf);
  }
  return mean;
}

}  // namespace

double ggxBrdf(const GgxSurface& surface, double cosOut, double cosIn, double phi) {
  const double alphaSquared = std::pow(surface.roughness, 4.0);
  const double sinOut = std::sqrt(1.0 - cosOut * cosOut), sinIn = std::sqrt(1.0 - cosIn * cosIn);
  const double x = sinOut + sinIn * std::cos(phi), y = sinIn * std::sin(phi), z = cosOut + cosIn;
  const double cosHSquared = z * z / (x * x + y * y + z * z);
  const double spread = cosHSquared * (alphaSquared - 1.0) + 1.0;
  const double normals = alphaSquared / (kPi * spread * spread);
  return normals * maskingShadowing(surface, cosOut, cosIn) / (4.0 * cosOut * cosIn);
}

FBetaTerms fBetaOracle(const GgxSurface& surface, double cosOut, int order) {
  const double alpha = surface.roughness * surface.roughness;
  const double thetaOut = std::acos(cosOut);
  // Half vectors nearer than the first limit never lead below the horizon, those beyond the second always.
  const double limits[] = {0.0, 0.25 * kPi - 0.5 * thetaOut, 0.25 * kPi + 0.5 * thetaOut};
  const std::vector<Node>& nodes = smoothedNodes(order);
  FBetaTerms sum;
  for (int part = 0; part < 2; ++part) {
    // tan(theta) = alpha tan(q) makes D(h) cos(theta) dh = sin(2q) dq dphi / 2pi.
    const double from = std::atan(std::tan(limits[part]) / alpha);
    const double width = std::atan(std::tan(limits[part + 1]) / alpha) - from;
    for (const Node& node : nodes) {
      const double q = from + width * node.at;
      const double weight = node.weight * width * std::sin(2.0 * q);
      const FBetaTerms mean = azimuthMean(surface, cosOut, std::atan(alpha * std::tan(q)), nodes);
      sum.scale += weight * mean.scale;
      sum.bias += weight * mean.bias;
    }
  }
  return sum;
}

FBetaTerms fBetaBruteForce(const GgxSurface& surface, double cosOut, int steps) {
  const double sinOut = std::sqrt(1.0 - cosOut * cosOut);
  FBetaTerms sum;
  for (int i = 0; i < steps; ++i) {
    const double theta = 0.5 * kPi * (i + 0.5) / steps;
    const double cosIn = std::cos(theta), sinIn = std::sin(theta);
    for (int j = 0; j < steps; ++j) {
      const double phi = kPi * (j + 0.5) / steps;  // the other half is its mirror image
      const double cosAngle = cosOut * cosIn + sinOut * sinIn * std::cos(phi);
      const double solidAngle = sinIn * kPi * kPi / (double(steps) * steps);
      add(sum, ggxBrdf(surface, cosOut, cosIn, phi) * cosIn * solidAngle, std::sqrt(0.5 + 0.5 * cosAngle));
    }
  }
  return sum;
}

double absCosine(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  const double lengths = a.norm() * b.norm();
  return lengths > 0.0 ? std::min(std::abs(a.dot(b)) / lengths, 1.0) : 0.0;
}

}  // namespace quell::tests
