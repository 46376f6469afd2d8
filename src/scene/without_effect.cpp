#include "scene/without_effect.h"

#include "base/error.h"

#include <fmt/format.h>

namespace orbs::scene {

namespace {

// Materials that have a form without an effect overload leave_out. A type that does not must not call for the
// effect: its image would silently stay as it is.
void leave_out_of(const SpectrumList& spectra, Effect effect, Material& material) {
  std::visit(
      [&](auto& model) {
        if constexpr (requires { leave_out(effect, model); }) leave_out(effect, model);
        for (const auto& verdict : effects(spectra, model))
          if (verdict.effect == effect && verdict.is_called_for)
            throw InputError(
                fmt::format("material '{}' {}, and the type {} has no form without the effect '{}'",
                            material.name, verdict.reason, model.kType, effect_name(effect)));
      },
      material.model);
}

}  // namespace

bool leave_out(Effect effect, Scene& scene) {
  if (effect != Effect::Dispersion && effect != Effect::MeasuredMetal && effect != Effect::ThinFilm)
    return false;
  for (auto& material : scene.materials) leave_out_of(scene.spectra, effect, material);
  return true;
}

}  // namespace orbs::scene
