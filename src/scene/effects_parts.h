#pragma once

#include "scene/effects.h"

#include <string>
#include <vector>

/// What effects() asks about single things of a scene.
namespace orbs::scene {

struct EffectVerdict {
  Effect effect = Effect::Spectral;
  bool is_called_for = false;
  std::string reason;
};

/// What the material would call for if a surface showed it. What emits is judged by verdict_on_light.
std::vector<EffectVerdict> verdicts_on(const Scene& scene, const MaterialModel& model);

/// Whether light of different wavelengths is scattered differently.
bool is_coloured(const Scene& scene, const MaterialModel& model);

/// Whether a light's spectrum is more than its colour: not when it is D65, which is what a colour stands for,
/// and not where all surfaces treat all wavelengths alike.
EffectVerdict verdict_on_light(const Scene& scene, const SpectrumUse& use, bool has_coloured_surface);

}  // namespace orbs::scene
