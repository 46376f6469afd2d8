#include "tracer/accel/openings.h"

#include "base/nth.h"
#include "tracer/colour/uv_at.h"
#include "tracer/sampling/hash.h"

#include <algorithm>
#include <bit>
#include <cstdint>

namespace orbs::tracer {

namespace {

float share_at(const Openings& openings, const MaterialOpacity& opacity, const Hit& hit) {
  if (opacity.texture < 0) return opacity.share;
  const TriangleMesh& mesh = openings.meshes[openings.objects[hit.object].mesh];
  const Vec3f texel = lookup(nth(openings.textures, opacity.texture), uv_at(mesh, hit, opacity.uv));
  const float white = std::max({texel.x, texel.y, texel.z});
  return opacity.at_black * (1 - white) + opacity.share * white;
}

// Even in [0, 1).
float number_of(Vec3f origin, Vec3f direction, const Hit& hit) {
  std::uint32_t digits = 0;
  for (const float value : {origin.x, origin.y, origin.z, direction.x, direction.y, direction.z})
    digits = hash(digits ^ std::bit_cast<std::uint32_t>(value));
  digits = hash(digits ^ hit.object);
  digits = hash(digits ^ hit.primitive);
  return static_cast<float>(digits >> 8U) * 0x1p-24F;
}

}  // namespace

bool may_let_pass(const Openings& openings, const RenderObject& object) {
  if (openings.of_material.empty()) return false;
  return std::any_of(object.material_of.begin(), object.material_of.end(), [&](int material) {
    const MaterialOpacity& opacity = nth(openings.of_material, material);
    return opacity.share < 1 || opacity.texture >= 0;
  });
}

bool passes(const Openings& openings, Vec3f origin, Vec3f direction, const Hit& hit) {
  const RenderObject& object = openings.objects[hit.object];
  const int own = openings.meshes[object.mesh].materials[hit.primitive];
  const MaterialOpacity& opacity = nth(openings.of_material, nth(object.material_of, own));
  if (opacity.share == 1 && opacity.texture < 0) return false;
  return !(number_of(origin, direction, hit) < share_at(openings, opacity, hit));
}

}  // namespace orbs::tracer
