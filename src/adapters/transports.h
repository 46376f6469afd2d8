#pragma once

#include "registry/configuration.h"
#include "scene/scene.h"

#include <string>

/// What a renderer must be told of what the light paths of a scene carry: some have a program, or a variant
/// of it, for each.
namespace orbs::adapters {

/// InputError when `transports` of the renderer names none of scene::kTransports, or gives words that its
/// command never uses.
void check_transports(const registry::Renderer& renderer);

/// What {transport} stands for: the renderer's word for scene::transport, or that name itself where it has
/// none. "" where its command does not ask: finding out means to go through the whole scene.
std::string transport_word(const registry::Renderer& renderer, const scene::Scene& scene);

/// "" when the renderer has a word for what the scene calls for, or none for anything; else a reason that
/// says what is missing.
std::string transport_limit(const registry::Renderer& renderer, const scene::Scene& scene);

}  // namespace orbs::adapters
