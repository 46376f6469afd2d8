#include "tracer/world/build_materials.h"

#include "scene/scene.h"

namespace orbs::tracer {

namespace {

// Up to this roughness light paths find the light in a lobe better than light sampling at the surface itself.
constexpr float kNearSpecularAlpha = 0.3F;

bool is_appearance(const MaterialModel& model) {
  return std::visit([](const auto& m) { return std::decay_t<decltype(m)>::kIsAppearance; }, model);
}

}  // namespace

void add_materials(const scene::Scene& scene, const SceneColours& colours, World& world) {
  for (const auto& material : scene.materials) {
    SurfaceMaterial out{
        .model = std::visit([&](const auto& m) -> MaterialModel { return make_material(m, colours); },
                            material.model)};
    const float alpha = std::visit([](const auto& m) { return lobe_alpha(m); }, out.model);
    out.is_delta = alpha == 0;
    out.is_near_specular = alpha < kNearSpecularAlpha;
    world.materials.push_back(std::move(out));
  }
  for (const int index : scene::visible_materials(scene))
    world.has_appearance_materials = world.has_appearance_materials ||
                                     is_appearance(world.materials[static_cast<std::size_t>(index)].model);
}

}  // namespace orbs::tracer
