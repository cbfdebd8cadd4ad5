// Materials by name, so that scenes read as descriptions.
#pragma once

#include "host/render/scene.hpp"

namespace quell::render {

// Reflectance of metals at normal incidence, linear Rec. 709 (Hoffman 2010, Physically-Based Shading Models in Film and
// Game Production, SIGGRAPH course, table 2; brass: Lagarde 2011).
constexpr glm::dvec3 kGold{1.00, 0.71, 0.29};
constexpr glm::dvec3 kSilver{0.95, 0.93, 0.88};
constexpr glm::dvec3 kCopper{0.95, 0.64, 0.54};
constexpr glm::dvec3 kIron{0.56, 0.57, 0.58};
constexpr glm::dvec3 kAluminium{0.91, 0.92, 0.92};
constexpr glm::dvec3 kBrass{0.91, 0.78, 0.42};

/// Reflectance of plastic, glass and varnish at normal incidence (index of refraction 1.5).
constexpr double kDielectric = 0.04;

/// Diffuse only.
Material matte(const glm::dvec3& albedo);
/// Diffuse below a clear GGX coat, F0 0.04.
Material glazed(const glm::dvec3& albedo, const Texture& roughness);
/// GGX only; F0 as above.
Material metal(const glm::dvec3& f0, const Texture& roughness);
/// Shines with the radiance, reflects nothing.
Material emitter(const glm::dvec3& radiance);

}  // namespace quell::render
