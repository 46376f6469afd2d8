#include "scene/without_effect.h"

namespace orbs::scene {

namespace {

spectra::RefractiveIndex frozen(const spectra::RefractiveIndex& index) {
  return spectra::constant(index_at(index, kUsualIndex_nm));
}

struct LeaveOut {
  Effect effect;

  void operator()(Dielectric& m) const {
    if (effect == Effect::ThinFilm) m.film.reset();
    if (effect != Effect::Dispersion) return;
    m.index = frozen(m.index);
    m.outside = frozen(m.outside);
  }
  void operator()(Conductor& m) const {
    if (effect == Effect::ThinFilm) m.film.reset();
    if (effect != Effect::MeasuredMetal) return;
    m.index = {spectra::constant(value_at(m.index.n, kUsualIndex_nm)),
               spectra::constant(value_at(m.index.k, kUsualIndex_nm))};
    m.outside = frozen(m.outside);
  }
  void operator()(const auto&) const {}
};

}  // namespace

bool leave_out(Effect effect, Scene& scene) {
  if (effect != Effect::Dispersion && effect != Effect::MeasuredMetal && effect != Effect::ThinFilm)
    return false;
  for (auto& material : scene.materials) std::visit(LeaveOut{effect}, material.model);
  return true;
}

}  // namespace orbs::scene
