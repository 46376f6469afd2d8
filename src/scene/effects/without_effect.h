#pragma once

#include "scene/effects/effects.h"

#include <string>
#include <vector>

namespace orbs::scene {

/// Makes the scene, in place, as a renderer without the effect would draw it:
///   Dispersion     every index is that of kUsualIndex_nm (materials/boundary.h)
///   MeasuredMetal  n and k are those of that wavelength
///   ThinFilm       no films
/// False, and nothing changes, for the other effects: they are left out by the transport, see WorldSettings
/// of the tracer. InputError naming the first material that calls for the effect and has no form without it.
bool leave_out(Effect effect, Scene& scene);

/// InputError where `verdicts`, those of a material of this name and type, still call for the effect.
void refuse_effect(Effect effect,
                   const std::vector<EffectVerdict>& verdicts,
                   const std::string& material,
                   const char* type);

/// The same for one material of the scene. Types that have a form without an effect overload
/// leave_out(effect, model) beside their struct. A type that does not must not call for the effect, because
/// its image would silently stay as it is.
template <MaterialType Model>
void leave_out_of(const SpectrumList& spectra, Effect effect, const std::string& material, Model& model) {
  if constexpr (requires { leave_out(effect, model); }) leave_out(effect, model);
  refuse_effect(effect, effects(spectra, model), material, Model::kType);
}

}  // namespace orbs::scene
