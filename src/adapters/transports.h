#pragma once

#include "base/error.h"
#include "base/text.h"
#include "registry/configuration.h"
#include "registry/placeholders.h"
#include "scene/effects/effects.h"
#include "scene/scene.h"

#include <set>
#include <string>

#include <fmt/format.h>
#include <fmt/ranges.h>

/// How a renderer is told what the light paths of a scene carry: some have a program, or a variant of it, for
/// each transport.

namespace orbs::adapters {

/// InputError when `transports` of the renderer names none of scene::kTransports, or gives words that its
/// command never uses.
inline void check_transports(const registry::Renderer& renderer) {
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

/// The value of {transport}: the renderer's word for scene::transport, or the name itself where it has none.
/// "" where its command does not use it, since the answer takes a look at the whole scene.
inline std::string transport_word(const registry::Renderer& renderer, const scene::Scene& scene) {
  if (!registry::uses_placeholder(renderer.command.words, "transport")) return "";
  const std::string name(scene::transport_name(scene::transport(scene)));
  const auto own = renderer.format.transports.find(name);
  return own == renderer.format.transports.end() ? name : own->second;
}

/// "" when the renderer has a word for what the scene calls for, or none for anything; else a reason that
/// says what is missing.
inline std::string transport_limit(const registry::Renderer& renderer, const scene::Scene& scene) {
  if (renderer.format.transports.empty()) return "";
  const auto found = scene::effects(scene);
  const std::string name(scene::transport_name(scene::transport(found)));
  if (renderer.format.transports.contains(name)) return "";
  return fmt::format("it calls for {} light paths{}, for which the renderer's 'transports' has no word", name,
                     scene::reason_for(found));
}

}  // namespace orbs::adapters
