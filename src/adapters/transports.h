#pragma once

#include "registry/configuration.h"
#include "scene/scene.h"

#include <string>

/// How a renderer is told what the light paths of a scene carry: some have a program, or a variant of it, for
/// each transport.
namespace orbs::adapters {

/// InputError when `transports` of the renderer names none of scene::kTransports, or gives words that its
/// command never uses.
void check_transports(const registry::Renderer& renderer);

/// The value of {transport}: the renderer's word for scene::transport, or the name itself where it has none.
/// "" where its command does not use it, since the answer takes a look at the whole scene.
std::string transport_word(const registry::Renderer& renderer, const scene::Scene& scene);

/// "" when the renderer has a word for what the scene calls for, or none for anything; else a reason that
/// says what is missing.
std::string transport_limit(const registry::Renderer& renderer, const scene::Scene& scene);

}  // namespace orbs::adapters
