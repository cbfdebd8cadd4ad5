// How the surfaces and the sky of the built-in test scene look. Every function is pure and free of noise.
#pragma once

#include <glm/glm.hpp>

#include "host/analytic/scene.hpp"

namespace quell::io::analytic {

/// Share of light that the surface reflects, linear RGB, each in [0, 1). Zero on the lamp's shining face.
glm::dvec3 albedoAt(const Hit& hit);

/// Radiance that the surface sends out by itself, linear RGB, >= 0. Zero but on the lamp's shining face.
glm::dvec3 emissionAt(const Hit& hit);

/// Normal for shading: unit length, faces the viewer. Differs from the geometric one on the bricks alone.
/// `viewDirection` is the direction of the ray that found the hit.
glm::dvec3 shadingNormalAt(const Hit& hit, const glm::dvec3& viewDirection);

/// Radiance from the open air in a unit direction, linear RGB, > 0: sky above the horizon, sea below.
/// The sun's disc is not in it; it is a light of its own (analytic_light.hpp).
glm::dvec3 skyRadiance(const glm::dvec3& direction);

/// Radiance of the lamp's shining face, linear RGB. With an area of 2 m^2, 3 m above the floor, it gives the
/// floor below it an irradiance / pi of about 0.8.
constexpr glm::dvec3 kLampRadiance{12.0, 10.0, 7.2};

}  // namespace quell::io::analytic
