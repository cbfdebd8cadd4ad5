#include "host/render/materials.hpp"

namespace quell::render {

Material matte(const glm::dvec3& albedo) {
  Material material;
  material.albedoA = albedo;
  material.albedoB = albedo;
  material.f0 = glm::dvec3(0.0);
  material.metalF0 = glm::dvec3(0.0);
  material.roughness = 1.0;
  return material;
}

Material glazed(const glm::dvec3& albedo, const Texture& roughness) {
  Material material = matte(albedo);
  material.f0 = glm::dvec3(kDielectric);
  material.metalF0 = glm::dvec3(kDielectric);
  material.tint = glm::dvec3(1.0);
  material.roughness = roughness;
  return material;
}

Material metal(const glm::dvec3& f0, const Texture& roughness) {
  Material material = glazed(glm::dvec3(0.0), roughness);
  material.f0 = f0;
  material.metalF0 = f0;
  return material;
}

Material emitter(const glm::dvec3& radiance) {
  Material material;
  material.emission = radiance;
  return material;
}

}  // namespace quell::render
