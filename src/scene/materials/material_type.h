#pragma once

#include "scene/colour.h"
#include "scene/effects/effect.h"

#include <concepts>
#include <string_view>
#include <vector>

namespace orbs::json {
class ObjectReader;
class Writer;
}  // namespace orbs::json

/// A type of material is a struct with `kType`, its word in the scene file, and the free functions of
/// MaterialType beside it; all of it is one header and one source file of this folder and a line in the
/// variant MaterialModel. A function that is missing is a compile error. A `texture` or a `spectrum` of the
/// struct is found by its name (texture_of, spectrum_of).
namespace orbs::scene {

class Names;
struct Material;
struct SpectralData;

/// What a material is read from: its entry in the scene file, and what the names in it refer to.
struct MaterialEntry {
  json::ObjectReader& in;
  const Names& textures;
  SpectralData& spectra;
  const Names& names;                   // of the materials
  const std::vector<Material>& before;  // those that stand before it
};

/// The requirement that a material calls for by its type alone.
struct MaterialRequirement {
  const char* code;
  const char* what;  // follows "is": "rough glass"
};

/// load: reads all members but name and type; InputError at the key that is wrong.
/// write: the members that load reads but for `texture`, so that reading them gives the same material.
/// requirement: the level that draws this type; our group E for what goes beyond ORB.S.
/// effects: what the material would call for if a surface showed it. What emits is judged with the lights.
/// is_coloured: whether it scatters light of different wavelengths differently.
template <typename Model>
concept MaterialType = requires(const MaterialEntry& entry,
                                json::Writer& out,
                                const SpectrumList& spectra,
                                Model& loaded,
                                const Model& model) {
  { Model::kType } -> std::convertible_to<std::string_view>;
  { load(entry, loaded) } -> std::same_as<void>;
  { write(out, spectra, model) } -> std::same_as<void>;
  { requirement(model) } -> std::same_as<MaterialRequirement>;
  { effects(spectra, model) } -> std::same_as<std::vector<EffectVerdict>>;
  { is_coloured(spectra, model) } -> std::same_as<bool>;
};

}  // namespace orbs::scene
