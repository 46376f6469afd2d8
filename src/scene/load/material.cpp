#include "scene/load/material.h"

#include <type_traits>

namespace orbs::scene {

namespace {

template <typename Model>
bool load_if_named(const std::string& type, const MaterialEntry& entry, MaterialModel& model) {
  if (type != Model::kType) return false;
  load(entry, model.emplace<Model>());
  return true;
}

// `Models` are the types of the variant, so that the list of words is that of the types.
template <typename... Models>
MaterialModel load_model(const MaterialEntry& entry, std::type_identity<std::variant<Models...>>) {
  const std::string type = entry.in.one_of("type", {Models::kType...});
  MaterialModel model;
  (load_if_named<Models>(type, entry, model) || ...);
  return model;
}

}  // namespace

Material load_material(json::ObjectReader in, const Names& textures, SpectralData& spectra) {
  Material material;
  material.name = in.text("name");
  material.model = load_model({in, textures, spectra}, std::type_identity<MaterialModel>{});
  in.finish();
  return material;
}

}  // namespace orbs::scene
