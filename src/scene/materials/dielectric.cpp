#include "scene/materials/dielectric.h"

#include "scene/load/spectra.h"
#include "scene/materials/boundary.h"

#include <utility>

#include <fmt/format.h>

namespace orbs::scene {

namespace {

EffectVerdict effect_of_dispersion(const Dielectric& m) {
  const double span = index_ratio(m.index, m.outside).span();
  if (span > kLeastDispersion)
    return {Effect::Dispersion, true, fmt::format("has an index that varies by {:.3g}", span)};
  if (span > 0)
    return {
        Effect::Dispersion, false,
        fmt::format("has an index that varies by {:.3g}, which is less than {:g}", span, kLeastDispersion)};
  return {Effect::Dispersion, false, "has the same index at all wavelengths"};
}

std::optional<EffectVerdict> effect_of_film(const Dielectric& m) {
  if (!m.film) return std::nullopt;
  return effect_of(*m.film, m.outside, is_everywhere_equal(m.film->index, m.index));
}

}  // namespace

void load(const MaterialEntry& entry, Dielectric& loaded) {
  loaded.index = load_index(entry.in, "index", entry.spectra);
  loaded.outside = load_outside(entry);
  loaded.roughness = load_roughness(entry);
  loaded.film = load_film(entry);
}

void write(json::Writer& out, const SpectrumList&, const Dielectric& m) {
  write_index(out, "index", m.index);
  write_boundary(out, m.outside, m.roughness, m.film);
}

// Where it disperses, the effect calls for E6; how its index is written down does not change the boundary.
MaterialRequirement requirement(const Dielectric& m) {
  if (is_smooth_glass(m)) return {"M8", "smooth glass"};
  return {"E1", "a dielectric by its indices"};
}

std::vector<EffectVerdict> effects(const SpectrumList&, const Dielectric& m) {
  std::vector<EffectVerdict> found{effect_of_dispersion(m)};
  if (m.roughness) found.push_back(effect_of(*m.roughness));
  if (auto film = effect_of_film(m)) found.push_back(std::move(*film));
  return found;
}

bool is_coloured(const SpectrumList&, const Dielectric& m) {
  const auto film = effect_of_film(m);
  return is_dispersive(m) || (film && film->is_called_for);
}

bool is_smooth_glass(const Dielectric& m) { return !m.roughness && !m.film; }

bool is_dispersive(const Dielectric& m) { return index_ratio(m.index, m.outside).span() > kLeastDispersion; }

void leave_out(Effect effect, Dielectric& m) {
  if (effect == Effect::ThinFilm) m.film.reset();
  if (effect != Effect::Dispersion) return;
  m.index = frozen(m.index);
  m.outside = frozen(m.outside);
}

}  // namespace orbs::scene
