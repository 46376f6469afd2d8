#include "scene/effects/switches.h"

#include "scene/effects/effects.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>
#include <variant>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace orbs::scene {

namespace {

// How a surface scatters, by the level that tests it. What is both smooth and diffuse, as plastic, has two
// words.
struct Scattering {
  std::string_view code;
  std::string_view word;
};

constexpr std::array kScatterings{
    Scattering{"M3", "mirrors"},     Scattering{"E3", "mirrors"}, Scattering{"M8", "glass"},
    Scattering{"A4", "rough-glass"}, Scattering{"A2", "glossy"},  Scattering{"B1", "glossy"},
    Scattering{"B2", "glossy"},      Scattering{"B3", "glossy"},  Scattering{"B4", "glossy"},
    Scattering{"B5", "glossy"},      Scattering{"B6", "glossy"},  Scattering{"B7", "glossy"},
    Scattering{"B8", "glossy"},      Scattering{"B9", "glossy"},  Scattering{"E1", "glossy"},
};

std::string_view word_of(std::string_view code) {
  const auto* const found = std::find_if(kScatterings.begin(), kScatterings.end(),
                                         [&](const auto& one) { return one.code == code; });
  return found == kScatterings.end() ? std::string_view{} : found->word;
}

// What the surfaces of a scene do with light, and the first object that does it.
struct Surfaces {
  std::vector<LightSwitch> words;
  std::optional<std::string> diffuse;  // "material 'wall' is Lambertian"
  bool reflects = false;
};

void add_once(LightSwitch one, std::vector<LightSwitch>& all) {
  if (std::none_of(all.begin(), all.end(), [&](const auto& other) { return other.word == one.word; }))
    all.push_back(std::move(one));
}

Surfaces surfaces_of(const Scene& scene) {
  Surfaces found;
  std::vector<LightSwitch> textured;
  for (const int index : visible_materials(scene)) {
    const auto& material = material_at(scene, index);
    const auto needed = std::visit([](const auto& model) { return requirement(model); }, material.model);
    const auto what = fmt::format("material '{}' is {}", material.name, needed.what);
    if (!texture_uses(material).empty())
      add_once({"textures", fmt::format("material '{}' has a texture", material.name)}, textured);
    if (std::holds_alternative<Emission>(material.model)) continue;
    found.reflects = true;
    const auto word = word_of(needed.code);
    if (word.empty()) {
      if (!found.diffuse) found.diffuse = what;
    } else {
      add_once({std::string(word), what}, found.words);
    }
  }
  const auto rank = [](const LightSwitch& one) {
    constexpr std::array<std::string_view, 4> kOrder{"mirrors", "glass", "glossy", "rough-glass"};
    return std::find(kOrder.begin(), kOrder.end(), one.word) - kOrder.begin();
  };
  std::stable_sort(found.words.begin(), found.words.end(),
                   [&](const auto& a, const auto& b) { return rank(a) < rank(b); });
  found.words.insert(found.words.end(), textured.begin(), textured.end());
  return found;
}

std::string with_hyphens(std::string_view name) {
  std::string word(name);
  std::replace(word.begin(), word.end(), ' ', '-');
  return word;
}

}  // namespace

int bounces_that_matter(const Scene& scene) { return surfaces_of(scene).reflects ? scene.trace_depth : 0; }

std::vector<LightSwitch> light_switches(const Scene& scene) {
  const auto surfaces = surfaces_of(scene);
  auto switches = surfaces.words;
  const auto caster =
      std::find_if(switches.begin(), switches.end(), [](const auto& one) { return one.word != "textures"; });
  const bool has_caster = caster != switches.end();
  const auto cast_by = has_caster ? caster->what : std::string();
  if (shines(scene.environment)) switches.push_back({"environment", "the environment shines"});
  const bool has_bounces = surfaces.reflects && scene.trace_depth > 1;
  if (has_bounces)
    switches.push_back({"indirect", scene.trace_depth == kUnlimitedDepth
                                        ? "paths end by Russian roulette alone"
                                        : fmt::format("paths scatter up to {} times", scene.trace_depth)});
  if (has_bounces && has_caster && surfaces.diffuse)
    switches.push_back({"caustics", fmt::format("{}, and {}", cast_by, *surfaces.diffuse)});
  for (const auto& finding : effects(scene).called_for)
    add_once(
        {with_hyphens(effect_name(finding.effect)), fmt::format("{} {}", finding.object, finding.reason)},
        switches);
  // The effect of the same meaning.
  std::erase_if(switches, [](const auto& one) { return one.word == "texture"; });
  return switches;
}

std::string switch_words(const Scene& scene) {
  std::vector<std::string> words;
  for (const auto& one : light_switches(scene)) words.push_back(one.word);
  return words.empty() ? "none" : fmt::format("{}", fmt::join(words, ","));
}

}  // namespace orbs::scene
