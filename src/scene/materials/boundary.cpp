#include "scene/materials/boundary.h"

#include "scene/load/spectra.h"

#include <cmath>

#include <fmt/format.h>

namespace orbs::scene {

namespace {

using spectra::RefractiveIndex;

// The whole nanometres, and every wavelength at which a table bends.
std::vector<double> wavelengths_of(const RefractiveIndex& a, const RefractiveIndex& b) {
  auto out = whole_nanometres();
  for (const auto* index : {&a, &b})
    if (const auto* table = std::get_if<spectra::Spectrum>(index))
      for (const double nm : table->wavelengths_nm)
        if (nm >= spectra::kShortestLight_nm && nm <= spectra::kLongestSeen_nm) out.push_back(nm);
  return out;
}

}  // namespace

RefractiveIndex load_outside(const MaterialEntry& entry) {
  return entry.in.has("outside") ? load_index(entry.in, "outside", entry.spectra) : spectra::constant(1);
}

double load_alpha(json::ObjectReader& in, const char* key) { return in.number(key, {1e-4, 1.0}); }

Masking load_masking(json::ObjectReader& in) {
  return in.one_of_or("masking", "correlated", {"correlated", "separable"}) == "separable"
             ? Masking::Separable
             : Masking::Correlated;
}

std::optional<Roughness> load_roughness(const MaterialEntry& entry) {
  auto& in = entry.in;
  if (!in.has("alpha")) return std::nullopt;
  Roughness roughness;
  roughness.alpha = load_alpha(in);
  if (in.one_of_or("distribution", "ggx", {"ggx", "beckmann"}) == "beckmann")
    roughness.distribution = Distribution::Beckmann;
  if (in.one_of_or("masking", "separable", {"separable", "correlated"}) == "correlated")
    roughness.masking = Masking::Correlated;
  return roughness;
}

std::optional<Film> load_film(const MaterialEntry& entry) {
  if (!entry.in.has("film")) return std::nullopt;
  auto in = entry.in.object("film");
  Film film{load_index(in, "index", entry.spectra), in.number("height_nm", {0.0, 1e6})};
  in.finish();
  return film;
}

void write_boundary(json::Writer& out,
                    const RefractiveIndex& outside,
                    const std::optional<Roughness>& roughness,
                    const std::optional<Film>& film) {
  write_index(out, "outside", outside);
  if (roughness) {
    out.member("alpha", roughness->alpha);
    out.member("distribution", roughness->distribution == Distribution::Ggx ? "ggx" : "beckmann");
    out.member("masking", roughness->masking == Masking::Separable ? "separable" : "correlated");
  }
  if (!film) return;
  out.key("film").begin_object();
  write_index(out, "index", film->index);
  out.member("height_nm", film->height_nm).end_object();
}

IndexRatio index_ratio(const RefractiveIndex& a, const RefractiveIndex& b) {
  IndexRatio range{INFINITY, -INFINITY};
  for (const double nm : wavelengths_of(a, b)) {
    const double ratio = index_at(a, nm) / index_at(b, nm);
    range.smallest = std::fmin(range.smallest, ratio);
    range.largest = std::fmax(range.largest, ratio);
  }
  return range;
}

bool is_everywhere_equal(const RefractiveIndex& a, const RefractiveIndex& b) {
  const auto ratio = index_ratio(a, b);
  return ratio.smallest == 1 && ratio.largest == 1;
}

EffectVerdict effect_of(const Roughness& roughness) {
  return {Effect::RoughBoundary, true,
          fmt::format("is rough ({}, alpha {})",
                      roughness.distribution == Distribution::Ggx ? "GGX" : "Beckmann", roughness.alpha)};
}

EffectVerdict effect_of(const Film& film, const RefractiveIndex& outside, bool is_base_same) {
  if (film.height_nm == 0) return {Effect::ThinFilm, false, "has a film of thickness zero"};
  if (is_everywhere_equal(film.index, outside))
    return {Effect::ThinFilm, false, "has a film with the index of the outside, which is invisible"};
  if (is_base_same)
    return {Effect::ThinFilm, false,
            "has a film with the index of the material below it, which is invisible"};
  return {Effect::ThinFilm, true, fmt::format("has a film {} nm thick", film.height_nm)};
}

RefractiveIndex frozen(const RefractiveIndex& index) {
  return spectra::constant(index_at(index, kUsualIndex_nm));
}

}  // namespace orbs::scene
