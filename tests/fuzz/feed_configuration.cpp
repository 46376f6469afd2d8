#include "fuzz/feed.h"
#include "registry/configuration.h"
#include "registry/placeholders.h"

namespace orbs::fuzz {

namespace {

// Filling in asserts what reading has checked: every word in braces is known.
void check_renderer(const registry::Renderer& renderer) {
  registry::Placeholders values;
  for (const auto& name : registry::command_placeholders()) values[name] = name;
  for (const auto* words : {&renderer.command.words, &renderer.command.version_command})
    for (const auto& word : registry::fill_placeholders(*words, values))
      require(word.find('\0') == std::string::npos, "an argument ends where it seems to end");
  require(renderer.name.find('\0') == std::string::npos, "a name is one of a folder");
  require(registry::parse_features(registry::format_features(renderer.support.declares)) ==
              renderer.support.declares,
          "feature numbers mean the same after writing");
  registry::limit_reason(renderer, "M2");
}

}  // namespace

std::string feed_configuration(std::string_view bytes) {
  const std::filesystem::path file = "/nowhere/configuration.json";
  return complaint_of(file.string(), [&] {
    const auto configuration = registry::parse_configuration(file, std::string(bytes));
    for (const auto& renderer : configuration.renderers) check_renderer(renderer);
  });
}

}  // namespace orbs::fuzz
