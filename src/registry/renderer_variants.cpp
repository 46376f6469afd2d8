#include "registry/renderer_variants.h"

#include "registry/filters.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace orbs::registry {

const std::string& entry_of(const Renderer& renderer) {
  return renderer.variant_of.empty() ? renderer.name : renderer.variant_of;
}

std::vector<std::string> chosen_renderers(const Configuration& configuration, const std::string& list) {
  std::vector<std::string> names;
  for (const auto& renderer : configuration.renderers) names.push_back(renderer.name);
  std::vector<std::string> patterns;
  for (const auto& pattern : patterns_of(list)) {
    const auto count = patterns.size();
    for (const auto& renderer : configuration.renderers)
      if (renderer.variant_of == pattern) patterns.push_back(renderer.name);
    if (patterns.size() == count) patterns.push_back(pattern);
  }
  auto chosen = select_names(names, fmt::format("{}", fmt::join(patterns, ",")), "renderer");
  std::erase(patterns, "*");
  for (const auto& renderer : configuration.renderers)
    if (renderer.is_only_when_named && !matches_any(patterns, renderer.name))
      std::erase(chosen, renderer.name);
  return chosen;
}

namespace {

template <typename Key>
void replace_settings(const std::map<Key, std::map<std::string, double>>& own,
                      const Key& key,
                      Renderer& renderer) {
  const auto found = own.find(key);
  if (found == own.end()) return;
  for (const auto& [name, value] : found->second) renderer.format.settings[name] = value;
}

}  // namespace

Renderer at_size(Renderer renderer, SizeDivisor size_divisor) {
  replace_settings(renderer.format.settings_of_sizes, size_divisor, renderer);
  return renderer;
}

Renderer for_scene(Renderer renderer, const std::string& scene) {
  replace_settings(renderer.format.settings_of_scenes, scene, renderer);
  return renderer;
}

}  // namespace orbs::registry
