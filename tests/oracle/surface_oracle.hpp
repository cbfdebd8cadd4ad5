// Double-precision oracle of common/surface_images.h: position, normal, view depth and roughness of a pixel.
#pragma once

#include "kernels/common/reprojection_params.h"
#include "tests/oracle/demodulation_oracle.hpp"

namespace quell::tests {

/// All of the caller's images of one frame, and its camera.
struct FrameImages {
  MaterialImages material;
  io::Image normal;
  io::Image position;  ///< world positions, or view depth
  bool positionIsDepth = false;
  io::Image roughness;  ///< empty: absent
  ReprojectionParams reprojection{};
};

struct Surface {
  Vector3d position = Vector3d::Zero();  ///< relative to the camera
  Vector3d normal = Vector3d::Zero();
  bool valid = false;  ///< neither background nor broken
};

/// Sets `undecided` where float and double may disagree about a normal's length.
Surface surfaceAt(const FrameImages& frame, int x, int y, bool& undecided);

/// A normal as filters and history see it: turned in one of six ways by the channels whose factor vanishes.
Vector3d turnedNormal(const Vector3d& normal, const std::array<bool, 3>& weak);
/// The surface as they see it.
Surface filteredSurfaceAt(const FrameImages& frame, int x, int y, bool& undecided);

/// Along the view axis.
double viewDepthOf(const FrameImages& frame, const Surface& surface);
/// 1 where it is not finite.
double roughnessAt(const FrameImages& frame, int x, int y);

/// |cos| of the angle between view ray and normal; of a valid surface.
double cosineOf(const Surface& surface);
/// Fresnel reflectance at normal incidence, clamped; 0 where it is not finite.
Vector3d f0At(const FrameImages& frame, int x, int y);

/// Relative error of a handful of float operations.
constexpr double kSurfaceRounding = 1e-6;

Vector3d linearPart(const QuellFloat4& row);
/// Camera-relative point at view depth 1.
Vector3d viewRay(const ReprojectionParams& params, int x, int y);

}  // namespace quell::tests
