// Double-precision oracle of the F_beta table: the BRDF itself, and its integral over all incident directions.
#pragma once

#include <Eigen/Core>

namespace quell::tests {

/// The two terms of F_beta = F0 * scale + bias; both in [0, 1].
struct FBetaTerms {
  double scale = 0.0;
  double bias = 0.0;
};

/// Isotropic GGX with alpha = roughness^2, Smith's masking-shadowing and Schlick's Fresnel.
struct GgxSurface {
  double roughness = 1.0;   ///< above 0, at most 1
  bool correlated = false;  ///< height-correlated masking-shadowing instead of separable
};

/// Value of the BRDF for directions (cosTheta, sinTheta, 0) and (cosTheta, sinTheta cos(phi), ...), without Fresnel
/// term, 1/sr.
double ggxBrdf(const GgxSurface& surface, double cosOut, double cosIn, double phi);

/// Gauss-Legendre points along each axis of the oracle.
constexpr int kFBetaOracleOrder = 48;

/// Integral of the BRDF times cos(theta_i), cosOut in (0, 1]. Unlike the kernel it samples half vectors by the
/// distribution of normals about the surface normal, splits the domain where the incident direction meets the
/// horizon, and applies a Gauss-Legendre product rule of `order` points an axis to both parts, with end points
/// smoothed. Error: below 1e-6 at the default order over the table.
FBetaTerms fBetaOracle(const GgxSurface& surface, double cosOut, int order = kFBetaOracleOrder);

/// Same integral by a different route, brute force: midpoints of theta_i and phi over the hemisphere. Of use for
/// smooth surfaces only (roughness 0.5 and more); it checks the oracle.
FBetaTerms fBetaBruteForce(const GgxSurface& surface, double cosOut, int steps);

/// |cos| of the angle between two vectors; 0 if one of them is 0.
double absCosine(const Eigen::Vector3d& a, const Eigen::Vector3d& b);

}  // namespace quell::tests
