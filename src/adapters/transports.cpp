#include "adapters/transports.h"

#include "base/error.h"
#include "base/text.h"
#include "registry/placeholders.h"
#include "scene/effects/effects.h"

#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace orbs::adapters {

void check_transports(const registry::Renderer& renderer) {
  std::set<std::string> known;
  for (const auto transport : scene::kTransports) known.emplace(scene::transport_name(transport));
  for (const auto& [name, word] : renderer.format.transports)
    if (!known.contains(name))
      throw InputError(fmt::format("{}: transports: no light path is '{}'{}; known are: {}",
                                   entry_name(renderer), name, closest(name, known), fmt::join(known, ", ")));
  if (!renderer.format.transports.empty() && !registry::uses_placeholder(renderer.command.words, "transport"))
    throw InputError(
        fmt::format("{}: transports: its command does not use {{transport}}", entry_name(renderer)));
}

std::string transport_word(const registry::Renderer& renderer, const scene::Scene& scene) {
  if (!registry::uses_placeholder(renderer.command.words, "transport")) return "";
  const std::string name(scene::transport_name(scene::transport(scene)));
  const auto own = renderer.format.transports.find(name);
  return own == renderer.format.transports.end() ? name : own->second;
}

std::string transport_limit(const registry::Renderer& renderer, const scene::Scene& scene) {
  if (renderer.format.transports.empty()) return "";
  const auto found = scene::effects(scene);
  const std::string name(scene::transport_name(scene::transport(found)));
  if (renderer.format.transports.contains(name)) return "";
  return fmt::format("it calls for {} light paths{}, for which the renderer's 'transports' has no word", name,
                     scene::reason_for(found));
}

}  // namespace orbs::adapters
