#pragma once

#include "scene/scene.h"

#include <optional>

namespace orbs::scene {

/// Segments around the axis, and bands along curved profiles.
constexpr int kShapeSegments = 256;

/// A mesh of the shape before its matrix, with the normals and texture coordinates of the formula at its
/// vertices, which lie on the surface. The facets of quadrics and tori are within 8e-5 of the radius that
/// they turn with. Nothing for implicit surfaces and CSG.
std::optional<Mesh> tessellated(const ShapeForm& form);

/// Replaces the shapes of this level ("S1" or "S2") by meshes.
void tessellate_shapes(Scene& scene, const char* level);

}  // namespace orbs::scene
