// What a camera sees through one block: surfaces as positions and normals.
#pragma once

#include "host/stress/block.hpp"
#include "host/stress/random.hpp"

namespace quell::stress {

Vector3 add(const Vector3& a, const Vector3& b);
Vector3 scale(const Vector3& a, double s);
double dot(const Vector3& a, const Vector3& b);
Vector3 normalized(const Vector3& a);
/// Uniform over the sphere.
Vector3 randomDirection(Random& random);

/// A block of a perspective camera at the origin: rays through its pixels' centres.
class View {
 public:
  /// Looks anywhere; footprint of a pixel as with 400 to 2000 pixels per unit of tangent.
  explicit View(Random& random);

  const Vector3& forward() const { return m_forward; }
  const Vector3& right() const { return m_right; }
  const Vector3& up() const { return m_up; }
  /// Through the pixel; its component along forward() is 1.
  Vector3 ray(int pixel) const;
  /// Extent of the block at distance 1.
  double extent() const { return m_footprint * kBlockEdge; }

 private:
  Vector3 m_forward{}, m_right{}, m_up{};
  double m_footprint = 0.0;
};

/// A plane seen at no less than this cosine; `distance` along the view axis, scene units.
void addPlane(Block& block, const View& view, const Vector3& normal, double distance);

/// A plane facing the camera with waves of `height` (share of the block's extent); normals follow the waves.
void addWavySurface(Block& block, const View& view, double distance, double height, Random& random);

/// A sphere that fills the block. Its normals are an affine function of its positions.
void addSphere(Block& block, const View& view, double distance, Random& random);

/// Turns every normal by about `angle` (radians) in a random direction, as a fine normal map does.
void roughenNormals(Block& block, double angle, Random& random);

/// Moves every pixel along the view axis by up to `share` of the block's extent at `distance`, as leaves do.
void roughenPositions(Block& block, const View& view, double distance, double share, Random& random);

/// Pixels on one side of a random line through the block take the surface of `other`.
void cutByEdge(Block& block, const Block& other, Random& random);

void offsetPositions(Block& block, const Vector3& offset);

}  // namespace quell::stress
