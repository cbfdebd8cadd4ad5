// columns: a colonnade in the sun with railings and steps: many thin edges, hard shadows, sky between them.
#include "host/render/materials.hpp"
#include "host/render/scene_registry.hpp"
#include "host/render/scenes/props.hpp"

namespace quell::render {
namespace {

constexpr int kColumns = 9;
constexpr double kSpacingM = 1.6;
constexpr double kShaftM = 0.2;
constexpr double kHeightM = 3.0;

void addColumn(Scene& scene, const glm::dvec3& foot, int stone) {
  const auto at = [&](double z) { return Pose(foot + glm::dvec3(0.0, 0.0, z)); };
  const int id = scene.box(at(0.08), {0.32, 0.32, 0.08}, stone);
  scene.torus(at(0.22), 0.22, 0.06, stone, id);
  scene.cylinder(at(0.5 * kHeightM), kShaftM, 0.5 * kHeightM - 0.15, stone, id);
  scene.torus(at(kHeightM - 0.28), 0.2, 0.04, stone, id);
  scene.box(at(kHeightM - 0.08), {0.3, 0.3, 0.08}, stone, id);
}

void addStorey(Scene& scene, double floor, int stone, int iron) {
  for (int i = 0; i < kColumns; ++i)
    for (const double x : {-1.6, 1.6}) addColumn(scene, {x, kSpacingM * i, floor}, stone);
  const double middle = 0.5 * kSpacingM * (kColumns - 1);
  for (const double x : {-1.6, 1.6})
    scene.box({{x, middle, floor + kHeightM + 0.12}}, {0.28, middle + 0.5, 0.12}, stone);
  for (int i = 0; i + 1 < kColumns; ++i)
    for (const double x : {-1.6, 1.6})
      addRailing(scene, {x, kSpacingM * i + 0.3, floor}, {x, kSpacingM * (i + 1) - 0.3, floor}, 0.8, 7, iron);
}

}  // namespace

void columns(Scene& scene, double frame) {
  const double way = 0.035 * frame;  // m
  scene.camera.eye = {0.55, -3.4 + way, 1.55};
  scene.camera.target = {0.05 - 0.2 * way, 3.0, 1.95};
  scene.camera.fieldOfViewDeg = 58.0;
  scene.sky.zenith = {0.30, 0.52, 1.05};
  scene.sky.horizon = {0.95, 1.05, 1.15};
  scene.sky.ground = {0.30, 0.27, 0.22};
  scene.sky.sunDirection = {1.0, -0.35, 1.15};
  scene.sky.sunIrradiance = {4.3, 3.8, 3.1};

  Material sandstone = matte({0.62, 0.53, 0.40});
  sandstone.albedoB = {0.48, 0.38, 0.27};
  sandstone.pattern = {Pattern::Noise, 3.0};
  sandstone.bump = {Pattern::Noise, 9.0, 0.0, 0.012};
  const int stone = scene.add(sandstone);
  Material pavement = glazed({0.52, 0.5, 0.46}, {Pattern::Tiles, 1.25, 0.3, 0.6});
  pavement.albedoB = {0.3, 0.24, 0.2};
  pavement.pattern = {Pattern::Checker, 1.25};
  const int floor = scene.add(pavement);
  Material brick = matte({0.55, 0.52, 0.48});
  brick.albedoB = {0.5, 0.22, 0.14};
  brick.pattern = {Pattern::Bricks, 6.0};
  brick.bump = {Pattern::Bricks, 6.0, 0.0, 0.01};
  const int wall = scene.add(brick);
  const int iron = scene.add(glazed({0.03, 0.06, 0.05}, 0.35));
  const int cloth = scene.add(matte({0.6, 0.09, 0.07}));
  const int sea = scene.add(glazed({0.08, 0.16, 0.2}, 0.25));

  const double length = kSpacingM * (kColumns - 1);
  scene.box({{0.0, 0.5 * length, -0.1}}, {2.4, 0.5 * length + 4.5, 0.1}, floor);
  scene.rectangle({{0.0, 0.0, -1.2}}, 40.0, 40.0, sea);
  scene.rectangle({{-3.4, 0.5 * length, 2.0}, facing({1.0, 0.0, 0.0})}, 0.5 * length + 6.0, 3.2, wall);
  for (int step = 0; step < 5; ++step)
    scene.box({{0.0, length + 2.0 + 0.35 * step, 0.12 * (step + 1)}}, {2.3, 0.35, 0.12 * (step + 1)}, stone);
  addStorey(scene, 0.0, stone, iron);
  addStorey(scene, kHeightM + 0.24, stone, iron);
  for (int i = 1; i + 1 < kColumns; i += 2)
    scene.box({{1.6, kSpacingM * (i + 0.5), 2.0}, rotationAbout({0.0, 0.0, 1.0}, 4.0 * (i % 3))},
              {0.02, 0.45, 0.7}, cloth);
}

}  // namespace quell::render
