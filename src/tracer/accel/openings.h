#pragma once

#include "tracer/colour/texture.h"
#include "tracer/geometry/ray.h"
#include "tracer/geometry/render_object.h"

#include <vector>

namespace orbs::tracer {

/// The share of the rays that meet a surface, times the largest channel of a texture if it has one.
struct MaterialOpacity {
  float share = 1;  // of a white texel, or without a texture
  float at_black = 0;
  int texture = -1;  // index into World::textures
  UvMap uv{};
};

/// What surfaces let rays pass. The vectors must outlive it and must not move.
struct Openings {
  const std::vector<RenderObject>& objects;
  const std::vector<TriangleMesh>& meshes;
  const std::vector<TexelGrid>& textures;
  const std::vector<MaterialOpacity>& of_material;  // empty: all are opaque
};

/// Whether a triangle of the object may let rays pass.
bool may_let_pass(const Openings& openings, const RenderObject& object);

/// Whether the ray passes the place where it would hit a triangle. The choice is a function of the ray and
/// the triangle alone, so a path and its shadow rays meet the same surfaces in whatever order the traversal
/// finds them. Rays differ in some digit, and the hash of all their digits is as good as a random number.
bool passes(const Openings& openings, Vec3f origin, Vec3f direction, const Hit& hit);

}  // namespace orbs::tracer
