#include "host/analytic/scene.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace quell::io::analytic {
namespace {

// Rays start this far (m) off the surface they leave: far above the rounding of doubles at room size
// (about 1e-15 m), far below a pixel (about 5e-3 m).
constexpr double kRayStartM = 1e-7;

struct Box {
  glm::dvec3 low;
  glm::dvec3 high;
  Surface surface;
};

struct Sphere {
  glm::dvec3 centre;
  double radius;
  Surface surface;
};

// Vertical and without caps: both ends stand in boxes.
struct Column {
  glm::dvec2 centre;
  double radius;
  double zLow;
  double zHigh;
  Surface surface;
};

// The shell is made of thick slabs outside the room, so that only their inner faces are ever seen.
constexpr std::array kBoxes{
    Box{{-4.5, -5.5, -0.5}, {4.5, 4.0, 0.0}, Surface::WoodFloor},
    Box{{-4.5, -5.5, 3.4}, {4.5, 4.0, 3.9}, Surface::Plaster},       // ceiling
    Box{{-4.5, -5.5, 0.0}, {-4.0, 4.0, 3.4}, Surface::StripedWall},  // left
    Box{{4.0, -5.5, 0.0}, {4.5, 4.0, 3.4}, Surface::Bricks},         // right
    Box{{-4.0, -5.5, 0.0}, {4.0, -5.0, 3.4}, Surface::Plaster},      // behind the camera
    Box{{-4.0, 3.6, 0.0}, {4.0, 3.9, 0.45}, Surface::Sandstone},     // parapet of the open side
    Box{{-4.0, 3.6, 2.75}, {4.0, 3.9, 3.4}, Surface::Sandstone},     // its lintel
    Box{{-4.0, 3.6, 0.45}, {-3.4, 3.9, 2.75}, Surface::Sandstone},   // its left pier
    Box{{3.4, 3.6, 0.45}, {4.0, 3.9, 2.75}, Surface::Sandstone},     // its right pier
    Box{{-4.0, -1.2, 3.16}, {4.0, -0.92, 3.4}, Surface::BeamWood},   // ceiling beams
    Box{{-4.0, 2.1, 3.16}, {4.0, 2.38, 3.4}, Surface::BeamWood},
    Box{{-3.95, -0.6, 0.0}, {-3.35, 2.6, 0.46}, Surface::BenchWood},  // bench
    Box{{-2.5, -1.75, 0.0}, {1.25, 1.5, 0.012}, Surface::Rug},
    Box{{1.75, 0.5, 0.0}, {2.55, 1.3, 0.85}, Surface::Sandstone},  // pedestal
    Box{kLampLow, kLampHigh, Surface::Lamp},
};

constexpr std::array kSpheres{
    Sphere{{-1.35, 0.55, 0.682}, 0.67, Surface::RedPaint},
    Sphere{{0.3, -0.35, 0.462}, 0.45, Surface::Marble},
    Sphere{{-0.75, -0.95, 0.292}, 0.28, Surface::BluePaint},
    Sphere{{2.15, 0.9, 1.25}, 0.4, Surface::OchrePaint},
};

constexpr std::array kColumns{
    Column{{-1.15, 3.75}, 0.14, 0.45, 2.75, Surface::Sandstone},
    Column{{1.15, 3.75}, 0.14, 0.45, 2.75, Surface::Sandstone},
};

constexpr double kMiss = std::numeric_limits<double>::infinity();

/// Distance to where the ray enters the box, and the axis of that face; kMiss without an entry ahead.
std::pair<double, int> enterBox(const Ray& ray, const glm::dvec3& inverseDirection, const Box& box) {
  double enter = -kMiss;
  double leave = kMiss;
  int enterAxis = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double toLow = (box.low[axis] - ray.origin[axis]) * inverseDirection[axis];
    const double toHigh = (box.high[axis] - ray.origin[axis]) * inverseDirection[axis];
    if (const double first = std::min(toLow, toHigh); first > enter) {
      enter = first;
      enterAxis = axis;
    }
    leave = std::min(leave, std::max(toLow, toHigh));
  }
  return {enter <= leave && enter > kRayStartM ? enter : kMiss, enterAxis};
}

/// Smaller root of distance^2 + 2 b distance + c = 0 times a: where a ray enters a round thing; kMiss if
/// none.
double enterRound(double a, double b, double c) {
  const double discriminant = b * b - a * c;
  if (discriminant <= 0.0) return kMiss;
  const double enter = (-b - std::sqrt(discriminant)) / a;
  return enter > kRayStartM ? enter : kMiss;
}

double enterSphere(const Ray& ray, const Sphere& sphere) {
  const glm::dvec3 fromCentre = ray.origin - sphere.centre;
  return enterRound(1.0, glm::dot(fromCentre, ray.direction),
                    glm::dot(fromCentre, fromCentre) - sphere.radius * sphere.radius);
}

double enterColumn(const Ray& ray, const Column& column) {
  const glm::dvec2 direction(ray.direction);
  const glm::dvec2 fromCentre = glm::dvec2(ray.origin) - column.centre;
  const double enter = enterRound(glm::dot(direction, direction), glm::dot(fromCentre, direction),
                                  glm::dot(fromCentre, fromCentre) - column.radius * column.radius);
  const double z = ray.origin.z + enter * ray.direction.z;
  return z >= column.zLow && z <= column.zHigh ? enter : kMiss;
}

/// Fills the hit's distance, normal and surface where the box is nearer than what the hit holds.
void keepNearest(const Ray& ray, const glm::dvec3& inverseDirection, const Box& box, Hit& hit) {
  const auto [distance, axis] = enterBox(ray, inverseDirection, box);
  if (distance >= hit.distance) return;
  hit.distance = distance;
  hit.normal = glm::dvec3(0.0);
  hit.normal[axis] = ray.direction[axis] > 0.0 ? -1.0 : 1.0;
  hit.surface = box.surface;
}

void keepNearest(const Ray& ray, const Sphere& sphere, Hit& hit) {
  const double distance = enterSphere(ray, sphere);
  if (distance >= hit.distance) return;
  hit.distance = distance;
  hit.normal = glm::normalize(ray.origin + distance * ray.direction - sphere.centre);
  hit.surface = sphere.surface;
}

void keepNearest(const Ray& ray, const Column& column, Hit& hit) {
  const double distance = enterColumn(ray, column);
  if (distance >= hit.distance) return;
  const glm::dvec2 fromAxis = glm::dvec2(ray.origin + distance * ray.direction) - column.centre;
  hit.distance = distance;
  hit.normal = glm::dvec3(glm::normalize(fromAxis), 0.0);
  hit.surface = column.surface;
}

}  // namespace

std::optional<Hit> nearestHit(const Ray& ray) {
  Hit hit;
  hit.distance = kMiss;
  const glm::dvec3 inverseDirection = 1.0 / ray.direction;
  for (const Box& box : kBoxes) keepNearest(ray, inverseDirection, box, hit);
  for (const Sphere& sphere : kSpheres) keepNearest(ray, sphere, hit);
  for (const Column& column : kColumns) keepNearest(ray, column, hit);
  if (hit.distance == kMiss) return std::nullopt;
  hit.position = ray.origin + hit.distance * ray.direction;
  return hit;
}

bool isOccluded(const Ray& ray, double maxDistance) {
  const double limit = maxDistance - kRayStartM;
  const glm::dvec3 inverseDirection = 1.0 / ray.direction;
  for (const Sphere& sphere : kSpheres) {
    if (enterSphere(ray, sphere) < limit) return true;
  }
  for (const Column& column : kColumns) {
    if (enterColumn(ray, column) < limit) return true;
  }
  for (const Box& box : kBoxes) {
    if (enterBox(ray, inverseDirection, box).first < limit) return true;
  }
  return false;
}

}  // namespace quell::io::analytic
