#include "scene/effects/without_effect.h"

#include "base/error.h"

#include <fmt/format.h>

namespace orbs::scene {

void refuse_effect(Effect effect,
                   const std::vector<EffectVerdict>& verdicts,
                   const std::string& material,
                   const char* type) {
  for (const auto& verdict : verdicts)
    if (verdict.effect == effect && verdict.is_called_for)
      throw InputError(fmt::format("material '{}' {}, and the type {} has no form without the effect '{}'",
                                   material, verdict.reason, type, effect_name(effect)));
}

bool leave_out(Effect effect, Scene& scene) {
  if (effect != Effect::Dispersion && effect != Effect::MeasuredMetal && effect != Effect::ThinFilm)
    return false;
  for (auto& material : scene.materials)
    std::visit([&](auto& model) { leave_out_of(scene.spectra, effect, material.name, model); },
               material.model);
  return true;
}

}  // namespace orbs::scene
