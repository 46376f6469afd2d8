#include "scene/lower/effects.h"

namespace orbs::scene {

void drop_spectra(Scene& scene) {
  for (auto& material : scene.materials)
    std::visit(
        [](auto& model) {
          if constexpr (requires { model.spectrum; }) model.spectrum.reset();
        },
        material.model);
  for (auto& light : scene.lights) light.spectrum.reset();
  scene.environment_spectrum.reset();
  scene.spectra.clear();
}

}  // namespace orbs::scene
