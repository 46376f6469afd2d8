#include "registry/scene_settings.h"

namespace orbs::registry {

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
