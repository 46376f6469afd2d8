#pragma once

#include "scene/scene.h"

#include <string>
#include <vector>

/// What a renderer can switch on and off, and whether a scene needs it.
namespace orbs::scene {

/// A part of the light transport that a scene calls for, and the object in it that does.
struct LightSwitch {
  std::string word;  // "mirrors", as scene files and command lines write it: no blanks, no commas
  std::string what;  // "material 'a' is a mirror"
};

/// Each once, in this order: mirrors, glass, glossy (blurred reflection), rough-glass, textures, environment,
/// indirect (light from surfaces to surfaces), caustics (light that mirrors, glass or gloss cast onto a
/// surface), then the effects of effects(), with hyphens: thin-film. What no surface shows calls for nothing.
/// Whether light can get there is not traced: a mirror counts that sees only black.
std::vector<LightSwitch> light_switches(const Scene& scene);

/// The most scatterings of a path that can matter: the trace depth, or 0 where nothing reflects.
int bounces_that_matter(const Scene& scene);

/// "mirrors,indirect,caustics"; "none" where all that is seen emits.
std::string switch_words(const Scene& scene);

}  // namespace orbs::scene
