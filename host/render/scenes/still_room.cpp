#include "host/render/scenes/still_room.hpp"

#include "host/render/materials.hpp"
#include "host/render/scenes/props.hpp"

namespace quell::render {
namespace {

constexpr double kRightM = 2.8;

/// The right wall with an opening: two strips beside it, two above and below, and a cross of bars.
void addWindowWall(Scene& scene, int wall, int frame) {
  const glm::dmat3 inwards = facing({-1.0, 0.0, 0.0});  // x of the rectangle along world y, y along z
  const auto strip = [&](double y0, double y1, double z0, double z1) {
    scene.rectangle({{kRightM, 0.5 * (y0 + y1), 0.5 * (z0 + z1)}, inwards}, 0.5 * (y1 - y0), 0.5 * (z1 - z0),
                    wall);
  };
  strip(-4.6, -1.2, 0.0, 2.8);
  strip(1.0, 2.2, 0.0, 2.8);
  strip(-1.2, 1.0, 0.0, 0.9);
  strip(-1.2, 1.0, 2.3, 2.8);
  scene.box({{kRightM, -0.1, 1.6}}, {0.03, 0.03, 0.7}, frame);
  scene.box({{kRightM, -0.1, 1.6}}, {0.03, 1.1, 0.03}, frame);
}

void addShelf(Scene& scene, int wood) {
  const auto vase = [&](double x, double z, const glm::dvec3& color, double roughness) {
    const int glaze = scene.add(glazed(color, roughness));
    const int id = scene.cylinder({{x, 1.95, z + 0.12}}, 0.07, 0.12, glaze);
    scene.sphere({{x, 1.95, z + 0.28}}, 0.1, glaze, id);
  };
  for (const double z : {1.05, 1.6}) scene.box({{-1.0, 1.98, z}}, {1.0, 0.2, 0.02}, wood);
  vase(-1.75, 1.07, {0.55, 0.1, 0.08}, 0.15);
  vase(-1.3, 1.07, {0.1, 0.3, 0.5}, 0.3);
  vase(-0.4, 1.62, {0.6, 0.5, 0.15}, 0.2);
  for (int i = 0; i < 8; ++i) {
    const double height = 0.16 + 0.02 * ((i * 5) % 4);
    const glm::dvec3 cover(0.15 + 0.06 * ((i * 3) % 7), 0.12 + 0.05 * ((i * 5) % 7),
                           0.1 + 0.05 * ((i * 2) % 7));
    scene.box({{-0.9 + 0.085 * i, 1.98, 1.07 + height}}, {0.035, 0.14, height}, scene.add(matte(cover)));
  }
  for (int i = 0; i < 4; ++i)
    scene.box({{-1.8 + 0.1 * i, 1.98, 1.82}}, {0.04, 0.14, 0.2},
              scene.add(matte({0.5 - 0.1 * i, 0.3, 0.15 + 0.1 * i})));
}

}  // namespace

void addStillRoom(Scene& scene) {
  scene.camera.eye = {-0.6, -4.2, 1.5};
  scene.camera.target = {0.1, 0.4, 1.0};
  scene.camera.fieldOfViewDeg = 48.0;

  Material parquet = glazed({0.42, 0.26, 0.14}, {Pattern::Tiles, 3.0, 0.15, 0.45});
  parquet.albedoB = {0.3, 0.17, 0.09};
  parquet.pattern = {Pattern::Tiles, 3.0};
  Material paper = matte({0.6, 0.58, 0.52});
  paper.albedoB = {0.5, 0.52, 0.5};
  paper.pattern = {Pattern::Stripes, 2.0};
  const int white = scene.add(matte({0.7, 0.7, 0.68}));
  const int wall = scene.add(paper);
  const int wood = scene.add(glazed({0.28, 0.15, 0.08}, 0.25));
  addRoom(scene, {-2.6, -4.6, 0.0}, {kRightM, 2.2, 2.8}, {scene.add(parquet), white, wall, -1, wall, white});
  addWindowWall(scene, wall, white);
  addShelf(scene, wood);

  Material rug = matte({0.5, 0.1, 0.1});
  rug.albedoB = {0.55, 0.45, 0.3};
  rug.pattern = {Pattern::Checker, 4.0};
  rug.bump = {Pattern::Noise, 40.0, 0.0, 0.004};
  scene.box({{0.3, -0.5, 0.01}}, {1.3, 0.9, 0.01}, scene.add(rug));
  addTable(scene, {0.4, -0.3, 0.02}, {0.7, 0.45, 0.55}, wood);
  scene.sphere({{0.15, -0.25, 0.72}}, 0.15, scene.add(metal(kSilver, 0.12)));
  scene.torus({{0.6, -0.4, 0.61}}, 0.12, 0.04, scene.add(metal(kGold, 0.2)));
  const int cloth = scene.add(matte({0.12, 0.25, 0.35}));
  scene.roundedBox({{1.7, 0.9, 0.3}, rotationAbout({0.0, 0.0, 1.0}, -35.0)}, {0.5, 0.5, 0.3}, 0.12, cloth);
  scene.roundedBox({{1.98, 1.3, 0.75}, rotationAbout({0.0, 0.0, 1.0}, -35.0)}, {0.5, 0.14, 0.45}, 0.1, cloth);
  scene.cylinder({{-2.0, 0.4, 0.35}}, 0.28, 0.35, scene.add(glazed({0.5, 0.45, 0.4}, 0.35)));
  scene.sphere({{-2.0, 0.4, 0.95}}, 0.3, scene.add(glazed({0.08, 0.3, 0.1}, 0.5)));
}

}  // namespace quell::render
