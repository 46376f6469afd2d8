#include "scene/materials/conductor.h"

#include "scene/load/spectra.h"
#include "scene/materials/boundary.h"

#include <algorithm>

#include <fmt/format.h>

namespace orbs::scene {

namespace {

using spectra::Spectrum;

// One of n and k: a number, or a spectrum of the scene, or samples.
Spectrum load_curve(json::ObjectReader& in, const std::string& key, double least, const SpectralData& data) {
  if (in.holds_number(key)) return spectra::constant(in.number(key, {least, 100.0}));
  auto entry = in.object(key);
  Spectrum curve = entry.has("spectrum") ? find_spectrum(entry, data) : load_samples(entry);
  entry.finish();
  const double smallest = *std::min_element(curve.values.begin(), curve.values.end());
  if (!(smallest >= least)) in.fail(key, fmt::format("must be at least {}, falls to {}", least, smallest));
  return curve;
}

spectra::MetalIndex load_metal(json::ObjectReader in, SpectralData& data) {
  // Without any real part Fresnel's formulas still hold; what measures below this is a misprint.
  constexpr double kLeastN = 1e-3;
  spectra::MetalIndex metal;
  if (in.has("file")) {
    const auto table = load_table(in, data);
    metal = with_note("reading the metal that " + in.place("file") + " names",
                      [&] { return spectra::metal_of(table); });
  } else {
    metal.n = load_curve(in, "n", kLeastN, data);
    metal.k = load_curve(in, "k", 0, data);
  }
  in.finish();
  return metal;
}

bool is_measured(const Conductor& m) {
  return !is_constant(m.index.n) || !is_constant(m.index.k) || is_dispersive(m.outside);
}

std::optional<EffectVerdict> effect_of_film(const Conductor& m) {
  if (!m.film) return std::nullopt;
  const bool is_clear = is_constant(m.index.k) && m.index.k.values.front() == 0;
  return effect_of(*m.film, m.outside, is_clear && is_everywhere_equal(m.film->index, m.index.n));
}

}  // namespace

void load(const MaterialEntry& entry, Conductor& loaded) {
  loaded.index = load_metal(entry.in.object("index"), entry.spectra);
  loaded.outside = load_outside(entry);
  loaded.roughness = load_roughness(entry);
  loaded.film = load_film(entry);
}

void write(json::Writer& out, const SpectrumList&, const Conductor& m) {
  out.key("index").begin_object();
  write_curve(out, "n", m.index.n);
  write_curve(out, "k", m.index.k);
  out.end_object();
  write_boundary(out, m.outside, m.roughness, m.film);
}

MaterialRequirement requirement(const Conductor&) { return {"E1", "a conductor by its indices"}; }

std::vector<EffectVerdict> effects(const SpectrumList&, const Conductor& m) {
  const bool measured = is_measured(m);
  std::vector<EffectVerdict> found{{Effect::MeasuredMetal, measured,
                                    measured ? "has n and k that differ from wavelength to wavelength"
                                             : "has the same n and k at all wavelengths"}};
  if (m.roughness) found.push_back(effect_of(*m.roughness));
  if (auto film = effect_of_film(m)) found.push_back(std::move(*film));
  return found;
}

bool is_coloured(const SpectrumList&, const Conductor& m) {
  const auto film = effect_of_film(m);
  return is_measured(m) || (film && film->is_called_for);
}

void leave_out(Effect effect, Conductor& m) {
  if (effect == Effect::ThinFilm) m.film.reset();
  if (effect != Effect::MeasuredMetal) return;
  m.index = {spectra::constant(value_at(m.index.n, kUsualIndex_nm)),
             spectra::constant(value_at(m.index.k, kUsualIndex_nm))};
  m.outside = frozen(m.outside);
}

}  // namespace orbs::scene
