#include "tests/oracle/guided_solve_oracle.hpp"

#include <Eigen/Cholesky>
#include <cmath>

namespace quell::tests {
namespace {

constexpr int kFeatures = QUELL_GUIDED_FEATURES;
constexpr int kGuides = kFeatures - 1;
constexpr int kColumns = kFeatures + QUELL_GUIDED_CHANNELS;
constexpr double kLeastPixels = 2.0 * kFeatures;  // fewer: the mean alone
constexpr double kRounding = 1e-4;                // of a sum of weights

// Features times [features | colour].
using Moments = Eigen::Matrix<double, kFeatures, kColumns>;

Moments momentsAt(const GuidedSolveInputs& inputs, int signal, int x, int y) {
  Moments moments;
  int plane = QUELL_GUIDED_SUMS * signal;
  for (int a = 0; a < kFeatures; ++a) {
    for (int b = a; b < kColumns; ++b, ++plane) {
      moments(a, b) = inputs.windowMoments.at(plane, x, y);
      if (b < kFeatures) moments(b, a) = moments(a, b);
    }
  }
  return moments;
}

GuidedFit fitWindow(const Moments& moments, double epsilon) {
  GuidedFit fit;
  const double pixels = moments(0, 0);
  fit.used = pixels > 0.0;
  fit.undecided = std::abs(pixels - kLeastPixels) < kRounding * kLeastPixels;
  if (!fit.used) return fit;
  const Moments mean = moments / pixels;
  fit.mean = mean.leftCols<kFeatures>().row(0).transpose();
  fit.brightness = mean.row(0).tail<QUELL_GUIDED_CHANNELS>().maxCoeff();
  // He et al. 2013, eq. (19): in units in which the mean square of depth is 1.
  Eigen::Vector4d ridge(epsilon, epsilon, epsilon, epsilon * mean(QUELL_GUIDED_DEPTH, QUELL_GUIDED_DEPTH));
  const Eigen::RowVectorXd means = mean.row(0);
  const Eigen::MatrixXd covariance =
      mean.bottomRows<kGuides>() - mean.row(0).segment<kGuides>(1).transpose() * means;
  Eigen::Matrix4d guides = covariance.middleCols<kGuides>(1);
  fit.deviation.tail<kGuides>() = guides.diagonal().cwiseMax(0.0).cwiseSqrt();
  guides.diagonal() += ridge;
  const Eigen::MatrixXd colors = covariance.rightCols<QUELL_GUIDED_CHANNELS>();
  if (pixels >= kLeastPixels) {
    // Depths may be of any size: the diagonal is brought to 1.
    const Eigen::Matrix4d unit = guides.diagonal().cwiseSqrt().cwiseInverse().asDiagonal();
    fit.coefficients.bottomRows<kGuides>() = unit * (unit * guides * unit).ldlt().solve(unit * colors);
  }
  // Eq. (20).
  fit.coefficients.row(0) = mean.row(0).tail<QUELL_GUIDED_CHANNELS>() -
                            mean.row(0).segment<kGuides>(1) * fit.coefficients.bottomRows<kGuides>();
  return fit;
}

}  // namespace

std::vector<GuidedFit> guidedSolveOracle(const GuidedSolveInputs& inputs) {
  std::vector<GuidedFit> fits;
  for (int signal = 0; signal < inputs.signals(); ++signal)
    forEachPixel(inputs.windowMoments.size(), [&](int x, int y) {
      fits.push_back(fitWindow(momentsAt(inputs, signal, x, y), inputs.epsilon));
    });
  return fits;
}

}  // namespace quell::tests
