// Feature buffers: shapes, tree, motion vectors, hit distance.
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <vector>

#include "host/render/scenes/props.hpp"
#include "tests/render/render_support.hpp"

namespace quell::tests {
namespace {

using render::Pose;
using render::rotationAbout;

constexpr Size kSize{112, 84};

/// Pixel coordinates of a point (w = 1) or direction (w = 0), (0.5, 0.5) being the centre of the first pixel.
glm::dvec2 project(const render::PinholeCamera& camera, const glm::dvec3& p, double w = 1.0) {
  const Matrix4 m = render::worldToClip(camera, kSize.width, kSize.height);
  const auto row = [&](std::size_t r) {
    return m[4 * r] * p.x + m[4 * r + 1] * p.y + m[4 * r + 2] * p.z + w * m[4 * r + 3];
  };
  return {(0.5 + 0.5 * row(0) / row(3)) * kSize.width, (0.5 - 0.5 * row(1) / row(3)) * kSize.height};
}

/// Unit direction through the centre of a pixel.
glm::dvec3 rayThrough(const render::PinholeCamera& camera, int x, int y) {
  const glm::dvec3 forward = glm::normalize(camera.target - camera.eye);
  const glm::dvec3 right = glm::normalize(glm::cross(forward, {0.0, 0.0, 1.0}));
  const double scale = render::pixelAngle(camera, kSize.height);
  return glm::normalize(forward + scale * (x + 0.5 - 0.5 * kSize.width) * right +
                        scale * (0.5 * kSize.height - y - 0.5) * glm::cross(right, forward));
}

glm::dvec3 toObject(const Pose& pose, const glm::dvec3& world) {
  return glm::transpose(pose.rotation) * (world - pose.position);
}

/// Signed distance, or something that vanishes on the surface with a gradient of length 1 beside it.
double distanceTo(const render::Object& object, const glm::dvec3& p) {
  const glm::dvec4& s = object.size;
  const glm::dvec3 q = glm::abs(p);
  switch (object.shape) {
    case render::Shape::Sphere:
      return glm::length(p) - s.x;
    case render::Shape::Box:
      return std::max({q.x - s.x, q.y - s.y, q.z - s.z});
    case render::Shape::Cylinder:
      return std::max(std::hypot(p.x, p.y) - s.x, q.z - s.y);
    case render::Shape::Torus:
      return std::hypot(std::hypot(p.x, p.y) - s.x, p.z) - s.y;
    case render::Shape::RoundedBox:
      return glm::length(glm::max(q - (glm::dvec3(s) - s.w), glm::dvec3(0.0))) - s.w;
    case render::Shape::Rectangle:
      return std::max({q.z, q.x - s.x, q.y - s.y});
    case render::Shape::Disc:
      return std::max(q.z, std::hypot(p.x / s.x, p.y / s.y) > 1.0 ? 1.0 : 0.0);
  }
  return std::numeric_limits<double>::infinity();
}

/// One of each shape; all move between two moments, and so does the camera.
render::Scene shapesAt(double time) {
  render::Scene scene;
  scene.camera.eye = {0.1 * time, -7.0, 2.0 + 0.05 * time};
  scene.camera.target = {0.05 * time, 0.0, 0.6};
  const int grey = scene.add(render::matte(glm::dvec3(0.5)));
  const auto pose = [&](double x, double z, double spin) {
    return Pose({x + 0.03 * time, 0.02 * time, z}, rotationAbout({0.3, 1.0, 0.5}, 40.0 + spin * time));
  };
  scene.sphere(pose(-2.2, 0.0, 5.0), 0.6, grey);
  scene.box(pose(-0.7, 0.0, -4.0), {0.5, 0.4, 0.6}, grey);
  scene.cylinder(pose(0.9, 0.0, 3.0), 0.4, 0.6, grey);
  scene.torus(pose(2.4, 0.0, 6.0), 0.5, 0.2, grey);
  scene.roundedBox(pose(-1.8, 1.7, 2.0), {0.6, 0.5, 0.4}, 0.12, grey);
  const auto upright = [&](double x, double z, double spin) {
    return Pose(pose(x, z, spin).position, pose(x, z, spin).rotation * render::facing({0.2, -1.0, 0.3}));
  };
  scene.rectangle(upright(0.1, 1.8, 4.0), 0.7, 0.5, grey);
  scene.disc(upright(1.9, 1.8, -3.0), 0.7, 0.4, grey);
  return scene;
}

}  // namespace

TEST_CASE("hits lie on their shapes, in front of the right pixel", "[render]") {
  const render::Scene now = shapesAt(1.0);
  render::PathTracer tracer = makeTracer(kSize);
  const render::Features features = tracer.features(now, shapesAt(0.0));
  std::vector<int> seen(now.objects().size(), 0);
  for (int y = 0; y < kSize.height; ++y)
    for (int x = 0; x < kSize.width; ++x) {
      const int id = int(features.objectId.at(x, y, 0));
      if (id == 0) continue;
      const render::Object& object = now.objects()[std::size_t(id - 1)];
      ++seen[std::size_t(id - 1)];
      const glm::dvec3 position = pixel3(features.positionWorld, x, y),
                       normal = pixel3(features.normalWorld, x, y);
      CAPTURE(id, x, y);
      REQUIRE(std::abs(distanceTo(object, toObject(object.pose, position))) < 2e-4);
      REQUIRE(glm::length(normal) == Approx(1.0).margin(1e-5));
      REQUIRE(glm::dot(normal, now.camera.eye - position) > 0.0);
      const glm::dvec2 miss = project(now.camera, position) - glm::dvec2(x + 0.5, y + 0.5);
      REQUIRE(glm::length(miss) < 0.002);
      // Along the normal the distance grows at rate 1, except where two faces meet.
      const bool flat = object.shape == render::Shape::Rectangle || object.shape == render::Shape::Disc;
      if (!flat) {
        const double above = distanceTo(object, toObject(object.pose, position + 0.01 * normal));
        CHECK(above == Approx(0.01).margin(6e-4));
      }
    }
  for (const int pixels : seen) CHECK(pixels > 20);
}

TEST_CASE("motion vectors are those of the moving points", "[render]") {
  const render::Scene now = shapesAt(1.0), before = shapesAt(0.0);
  render::PathTracer tracer = makeTracer(kSize);
  const render::Features features = tracer.features(now, before);
  double fastest = 0.0;
  for (int y = 0; y < kSize.height; ++y)
    for (int x = 0; x < kSize.width; ++x) {
      const int id = int(features.objectId.at(x, y, 0));
      const glm::dvec2 motion{features.motion.at(x, y, 0), features.motion.at(x, y, 1)};
      CAPTURE(id, x, y);
      glm::dvec2 expected;
      if (id == 0) {  // a point at infinity
        const glm::dvec3 direction = rayThrough(now.camera, x, y);
        expected = project(before.camera, direction, 0.0) - glm::dvec2(x + 0.5, y + 0.5);
      } else {
        const Pose& pose = now.objects()[std::size_t(id - 1)].pose;
        const Pose& posePrev = before.objects()[std::size_t(id - 1)].pose;
        const glm::dvec3 inObject = toObject(pose, pixel3(features.positionWorld, x, y));
        expected = project(before.camera, posePrev.rotation * inObject + posePrev.position) -
                   glm::dvec2(x + 0.5, y + 0.5);
      }
      REQUIRE(glm::length(motion - expected) < 0.003);
      fastest = std::max(fastest, glm::length(motion));
    }
  CHECK(fastest > 0.5);
}

TEST_CASE("nothing moves where nothing does", "[render]") {
  const render::Scene scene = shapesAt(1.0);
  render::PathTracer tracer = makeTracer(kSize);
  for (const float value : tracer.features(scene, scene).motion.pixels) REQUIRE(value == 0.0f);
}

TEST_CASE("the tree finds what a search through all spheres finds", "[render]") {
  render::Scene scene;
  scene.camera.eye = {0.0, -9.0, 0.5};
  scene.camera.target = {0.0, 0.0, 0.0};
  const int grey = scene.add(render::matte(glm::dvec3(0.5)));
  render::SceneRandom random(3);
  for (int i = 0; i < 1500; ++i)
    scene.sphere({{random.uniform(-3.0, 3.0), random.uniform(-3.0, 3.0), random.uniform(-2.5, 2.5)}},
                 random.uniform(0.02, 0.15), grey);
  render::PathTracer tracer = makeTracer(kSize);
  const render::Features features = tracer.features(scene, scene);
  int wrong = 0, hits = 0;
  for (int y = 0; y < kSize.height; ++y)
    for (int x = 0; x < kSize.width; ++x) {
      const glm::dvec3 d = rayThrough(scene.camera, x, y);
      double nearest = std::numeric_limits<double>::infinity();
      int id = 0;
      for (const render::Object& object : scene.objects()) {
        const glm::dvec3 toCenter = object.pose.position - scene.camera.eye;
        const double along = glm::dot(toCenter, d);
        const double square = object.size.x * object.size.x - glm::dot(toCenter, toCenter) + along * along;
        if (square < 0.0 || along - std::sqrt(square) > nearest) continue;
        nearest = along - std::sqrt(square);
        id = object.id;
      }
      hits += id > 0 ? 1 : 0;
      wrong += id != int(features.objectId.at(x, y, 0)) ? 1 : 0;
    }
  CHECK(hits > 1000);
  CHECK(wrong <= 3);  // rays that graze a sphere may go either way in single precision
}

TEST_CASE("hit distance is that of the mirrored ray", "[render]") {
  render::Scene scene;
  scene.camera.eye = {0.0, -4.0, 1.5};
  scene.camera.target = {0.0, 0.0, 0.5};
  scene.sky = uniformSky(0.5);
  const int mirror = scene.add(render::metal(render::kSilver, 0.02));
  const int grey = scene.add(render::matte(glm::dvec3(0.5)));
  scene.rectangle({{0.0, 0.0, 0.0}}, 20.0, 20.0, mirror);
  scene.rectangle({{0.0, 16.0, 3.0}, render::facing({0.0, 0.0, -1.0})}, 30.0, 11.0,
                  grey);  // a ceiling, y from 5
  render::PathTracer tracer = makeTracer(kSize);
  const render::Features features = tracer.features(scene, scene);
  const render::Light light = tracer.light(1, 1);
  int met = 0, near = 0, missed = 0, none = 0;
  for (int y = 0; y < kSize.height; ++y)
    for (int x = 0; x < kSize.width; ++x) {
      const float distance = light.hitDistance.at(x, y, 0);
      if (features.objectId.at(x, y, 0) != 1.0f) {
        none += distance == QUELL_NO_HIT_DISTANCE ? 1 : 1000000;
        continue;
      }
      const glm::dvec3 position = pixel3(features.positionWorld, x, y);
      glm::dvec3 direction = glm::normalize(position - scene.camera.eye);
      direction.z = -direction.z;
      const double expected = 3.0 / direction.z;
      const double hitY = position.y + expected * direction.y;
      if (std::abs(hitY - 5.0) < 0.5 || expected > 12.0) continue;  // the ceiling's edge, and far away
      if (hitY < 5.0) {
        CHECK(distance == QUELL_MISS_DISTANCE);
        ++missed;
      } else {
        ++met;
        near += std::abs(distance - expected) < 0.05 * expected ? 1 : 0;
      }
    }
  CHECK(met > 100);
  CHECK(near > 0.97 * met);  // GGX has long tails
  CHECK(missed > 100);
  CHECK(none < 1000000);
}

}  // namespace quell::tests
