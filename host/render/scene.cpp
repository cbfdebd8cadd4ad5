#include "host/render/scene.hpp"

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <stdexcept>

namespace quell::render {
namespace {

constexpr double kPi = 3.14159265358979323846;

bool shines(const Material& material) { return glm::dot(material.emission, material.emission) > 0.0; }

/// How many components of Object::size the shape uses.
int measures(Shape shape) {
  switch (shape) {
    case Shape::Sphere:
      return 1;
    case Shape::Rectangle:
    case Shape::Disc:
    case Shape::Cylinder:
    case Shape::Torus:
      return 2;
    case Shape::Box:
      return 3;
    case Shape::RoundedBox:
      return 4;
  }
  return 0;
}

}  // namespace

glm::dmat3 rotationAbout(const glm::dvec3& axis, double angleDeg) {
  return glm::dmat3(glm::rotate(glm::dmat4(1.0), angleDeg * kPi / 180.0, axis));
}

glm::dmat3 facing(const glm::dvec3& direction) {
  const glm::dvec3 z = glm::normalize(direction);
  const glm::dvec3 other = std::abs(z.z) < 0.9 ? glm::dvec3(0.0, 0.0, 1.0) : glm::dvec3(0.0, 1.0, 0.0);
  const glm::dvec3 x = glm::normalize(glm::cross(other, z));
  return glm::dmat3(x, glm::cross(z, x), z);
}

int Scene::add(const Material& material) {
  m_materials.push_back(material);
  return int(m_materials.size()) - 1;
}

int Scene::addObject(Shape shape, const Pose& pose, const glm::dvec4& size, int material, int partOf) {
  for (int i = 0; i < measures(shape); ++i)
    if (!(size[i] > 0.0)) throw std::invalid_argument("a shape without extent");
  if (shines(m_materials.at(std::size_t(material))) && shape != Shape::Sphere && shape != Shape::Rectangle)
    throw std::invalid_argument("a light that is neither sphere nor rectangle");
  const int id = partOf > 0 ? partOf : ++m_lastId;
  m_objects.push_back({shape, size, pose, material, id});
  return id;
}

int Scene::sphere(const Pose& pose, double radius, int material, int partOf) {
  return addObject(Shape::Sphere, pose, {radius, 0.0, 0.0, 0.0}, material, partOf);
}

int Scene::box(const Pose& pose, const glm::dvec3& halfExtents, int material, int partOf) {
  return addObject(Shape::Box, pose, {halfExtents, 0.0}, material, partOf);
}

int Scene::rectangle(const Pose& pose, double halfX, double halfY, int material, int partOf) {
  return addObject(Shape::Rectangle, pose, {halfX, halfY, 0.0, 0.0}, material, partOf);
}

int Scene::disc(const Pose& pose, double halfAxisX, double halfAxisY, int material, int partOf) {
  return addObject(Shape::Disc, pose, {halfAxisX, halfAxisY, 0.0, 0.0}, material, partOf);
}

int Scene::cylinder(const Pose& pose, double radius, double halfHeight, int material, int partOf) {
  return addObject(Shape::Cylinder, pose, {radius, halfHeight, 0.0, 0.0}, material, partOf);
}

int Scene::torus(const Pose& pose, double radius, double tubeRadius, int material, int partOf) {
  return addObject(Shape::Torus, pose, {radius, tubeRadius, 0.0, 0.0}, material, partOf);
}

int Scene::roundedBox(const Pose& pose, const glm::dvec3& halfExtents, double edgeRadius, int material,
                      int partOf) {
  return addObject(Shape::RoundedBox, pose, {halfExtents, edgeRadius}, material, partOf);
}

}  // namespace quell::render
