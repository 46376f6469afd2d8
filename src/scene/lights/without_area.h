#pragma once

#include "scene/lights/light_type.h"

#include <concepts>
#include <optional>
#include <string>

/// What the kinds of lights without an area have in common: no ray meets them, nobody sees them, and no scale
/// changes their size. A matrix moves and turns them, so that they need no level for that of their own.
namespace orbs::scene {

template <typename Shape>
concept WithoutArea = !Shape::kHasArea;

void check_placed(json::ObjectReader&, const WithoutArea auto&, const Mat4&) {}
std::string beyond_levels(const WithoutArea auto&, const Mat4&) { return ""; }
Vec3d half_size(const WithoutArea auto&) { return {}; }
double cross_section_m2(const WithoutArea auto&) { return 0; }
LightHit hit(const WithoutArea auto&, Vec3d, Vec3d) { return {}; }

}  // namespace orbs::scene
