// Least squares in double precision, the yardstick of all fits in single.
#pragma once

#include <Eigen/QR>
#include <limits>

namespace quell::stress {

struct LeastSquaresSolution {
  Eigen::MatrixXd coefficients;  ///< a row for each column of the matrix
  double condition = 1.0;        ///< of the triangular factor; infinite where columns are dependent
};

/// Minimises |matrix x - right| for each column of `right`, by rank-revealing QR with column pivoting. Directions with
/// less than `rankTolerance` of the longest count as dependent: of all solutions, the shortest is taken.
inline LeastSquaresSolution leastSquares(const Eigen::MatrixXd& matrix, const Eigen::MatrixXd& right,
                                         double rankTolerance) {
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> qr;
  qr.setThreshold(rankTolerance);
  qr.compute(matrix);
  const Eigen::ArrayXd diagonal = qr.matrixQTZ().diagonal().array().abs();
  return {qr.solve(right), qr.rank() < matrix.cols() ? std::numeric_limits<double>::infinity()
                                                     : diagonal.maxCoeff() / diagonal.minCoeff()};
}

}  // namespace quell::stress
