#include "host/stress/geometry.hpp"

#include <cmath>

namespace quell::stress {
namespace {

constexpr double kTwoPi = 6.283185307179586;
// Share of the sphere's radius at which the block's far corner is seen; beyond, rays would miss it.
constexpr double kSphereFilled = 0.6;

Vector3 cross(const Vector3& a, const Vector3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

double centred(int i) { return i + 0.5 - 0.5 * kBlockEdge; }

}  // namespace

Vector3 add(const Vector3& a, const Vector3& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
Vector3 scale(const Vector3& a, double s) { return {a[0] * s, a[1] * s, a[2] * s}; }
double dot(const Vector3& a, const Vector3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vector3 normalized(const Vector3& a) { return scale(a, 1.0 / std::sqrt(dot(a, a))); }

Vector3 randomDirection(Random& random) {
  const double z = random.uniform(-1.0, 1.0);
  const double phi = random.uniform(0.0, kTwoPi);
  const double radius = std::sqrt(1.0 - z * z);
  return {radius * std::cos(phi), radius * std::sin(phi), z};
}

View::View(Random& random) {
  m_forward = randomDirection(random);
  m_right = normalized(cross(m_forward, randomDirection(random)));
  m_up = cross(m_right, m_forward);
  m_footprint = 1.0 / random.uniform(400.0, 2000.0);
}

Vector3 View::ray(int pixel) const {
  const double x = centred(pixel % kBlockEdge) * m_footprint;
  const double y = -centred(pixel / kBlockEdge) * m_footprint;
  return add(m_forward, add(scale(m_right, x), scale(m_up, y)));
}

void addPlane(Block& block, const View& view, const Vector3& normal, double distance) {
  const double along = dot(normal, view.forward());
  for (int i = 0; i < kBlockPixels; ++i) {
    const Vector3 ray = view.ray(i);
    block.positionRelative[i] = scale(ray, distance * along / dot(normal, ray));
    block.normalWorld[i] = scale(normal, along > 0.0 ? -1.0 : 1.0);
  }
}

void addWavySurface(Block& block, const View& view, double distance, double height, Random& random) {
  const double extent = view.extent() * distance;
  const double waveX = random.uniform(0.5, 1.5) * kTwoPi / extent;
  const double waveY = random.uniform(0.5, 1.5) * kTwoPi / extent;
  const double phaseX = random.uniform(0.0, kTwoPi);
  const double phaseY = random.uniform(0.0, kTwoPi);
  const double amplitude = height * extent;
  for (int i = 0; i < kBlockPixels; ++i) {
    const Vector3 ray = scale(view.ray(i), distance);
    const double x = dot(ray, view.right());
    const double y = dot(ray, view.up());
    const double depth = amplitude * (std::sin(waveX * x + phaseX) + std::sin(waveY * y + phaseY));
    const Vector3 slope = add(scale(view.right(), -amplitude * waveX * std::cos(waveX * x + phaseX)),
                              scale(view.up(), -amplitude * waveY * std::cos(waveY * y + phaseY)));
    block.positionRelative[i] = add(ray, scale(view.forward(), -depth));
    block.normalWorld[i] = normalized(add(scale(view.forward(), -1.0), slope));
  }
}

void addSphere(Block& block, const View& view, double distance, Random& random) {
  const double radius = view.extent() * distance / kSphereFilled * random.uniform(1.0, 4.0);
  const Vector3 centre = scale(view.forward(), distance + radius);
  for (int i = 0; i < kBlockPixels; ++i) {
    const Vector3 ray = view.ray(i);
    const double rayRay = dot(ray, ray);
    const double along = dot(ray, centre) / rayRay;
    const double missed = dot(centre, centre) - along * along * rayRay;
    const double t = along - std::sqrt((radius * radius - missed) / rayRay);
    block.positionRelative[i] = scale(ray, t);
    block.normalWorld[i] = scale(add(block.positionRelative[i], scale(centre, -1.0)), 1.0 / radius);
  }
}

void roughenNormals(Block& block, double angle, Random& random) {
  for (Vector3& normal : block.normalWorld)
    normal = normalized(add(normal, scale(randomDirection(random), angle)));
}

void roughenPositions(Block& block, const View& view, double distance, double share, Random& random) {
  const double most = share * view.extent() * distance;
  for (Vector3& position : block.positionRelative)
    position = add(position, scale(view.forward(), random.uniform(-most, most)));
}

void cutByEdge(Block& block, const Block& other, Random& random) {
  const double phi = random.uniform(0.0, kTwoPi);
  const double offset = random.uniform(-0.3, 0.3) * kBlockEdge;
  for (int i = 0; i < kBlockPixels; ++i) {
    const double side = std::cos(phi) * centred(i % kBlockEdge) + std::sin(phi) * centred(i / kBlockEdge);
    if (side < offset) continue;
    block.positionRelative[i] = other.positionRelative[i];
    block.normalWorld[i] = other.normalWorld[i];
    block.radiance[i] = other.radiance[i];
  }
}

void offsetPositions(Block& block, const Vector3& offset) {
  for (Vector3& position : block.positionRelative) position = add(position, offset);
}

}  // namespace quell::stress
