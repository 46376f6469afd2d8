#include "scene/effects_parts.h"

#include "spectra/observer.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace orbs::scene {

namespace {

using spectra::RefractiveIndex;
using spectra::Spectrum;

const NamedSpectrum& named(const Scene& scene, const SpectrumUse& use) {
  return scene.spectra[static_cast<std::size_t>(use.spectrum)];
}

// The whole nanometres, and every wavelength at which a table bends.
std::vector<double> wavelengths_of(const std::vector<const RefractiveIndex*>& indices) {
  std::vector<double> out;
  for (double nm = spectra::kShortestLight_nm; nm <= spectra::kLongestSeen_nm; nm += 1) out.push_back(nm);
  for (const auto* index : indices)
    if (const auto* table = std::get_if<Spectrum>(index))
      for (const double nm : table->wavelengths_nm)
        if (nm >= spectra::kShortestLight_nm && nm <= spectra::kLongestSeen_nm) out.push_back(nm);
  return out;
}

struct Extremes {
  double smallest = INFINITY;
  double largest = -INFINITY;
  double span() const { return largest - smallest; }
};

// Of a / b: what is refracted at an interface depends on nothing else.
Extremes ratio_of(const RefractiveIndex& a, const RefractiveIndex& b) {
  Extremes extremes;
  for (const double nm : wavelengths_of({&a, &b})) {
    const double ratio = index_at(a, nm) / index_at(b, nm);
    extremes.smallest = std::fmin(extremes.smallest, ratio);
    extremes.largest = std::fmax(extremes.largest, ratio);
  }
  return extremes;
}

bool is_everywhere_equal(const RefractiveIndex& a, const RefractiveIndex& b) {
  const auto ratio = ratio_of(a, b);
  return ratio.smallest == 1 && ratio.largest == 1;
}

bool is_measured(const Conductor& m) {
  return !is_constant(m.index.n) || !is_constant(m.index.k) || is_dispersive(m.outside);
}

EffectVerdict verdict_on_reflectance(const Scene& scene, const SpectrumUse& use) {
  const auto& [name, spectrum] = named(scene, use);
  if (use.scale == 0) return {Effect::Spectral, false, fmt::format("has spectrum '{}' times zero", name)};
  if (is_constant(spectrum))
    return {Effect::Spectral, false,
            fmt::format("has spectrum '{}', which is constant, not spectral: a grey says the same", name)};
  return {Effect::Spectral, true, fmt::format("reflects by spectrum '{}'", name)};
}

EffectVerdict verdict_on_roughness(const Roughness& roughness) {
  return {Effect::RoughInterface, true,
          fmt::format("is rough ({}, alpha {})",
                      roughness.distribution == Distribution::Ggx ? "GGX" : "Beckmann", roughness.alpha)};
}

EffectVerdict verdict_of(const Film& film, const RefractiveIndex& outside, bool is_base_same) {
  if (film.height_nm == 0) return {Effect::ThinFilm, false, "has a film of no height"};
  if (is_everywhere_equal(film.index, outside))
    return {Effect::ThinFilm, false, "has a film with the index of what is outside, which nobody sees"};
  if (is_base_same)
    return {Effect::ThinFilm, false, "has a film with the index of what it lies on, which nobody sees"};
  return {Effect::ThinFilm, true, fmt::format("has a film {} nm high", film.height_nm)};
}

std::optional<EffectVerdict> verdict_on_film(const Conductor& m) {
  if (!m.film) return std::nullopt;
  const bool is_clear = is_constant(m.index.k) && m.index.k.values.front() == 0;
  return verdict_of(*m.film, m.outside, is_clear && is_everywhere_equal(m.film->index, m.index.n));
}

std::optional<EffectVerdict> verdict_on_film(const Dielectric& m) {
  if (!m.film) return std::nullopt;
  return verdict_of(*m.film, m.outside, is_everywhere_equal(m.film->index, m.index));
}

bool shows_film(const auto& material) {
  const auto verdict = verdict_on_film(material);
  return verdict && verdict->is_called_for;
}

struct ModelVerdicts {
  const Scene& scene;
  std::vector<EffectVerdict>& out;

  void operator()(const Lambert& m) const { reflects(m.spectrum); }
  void operator()(const OrenNayar& m) const { reflects(m.spectrum); }
  void operator()(const Mirror& m) const { reflects(m.spectrum); }
  void operator()(const Glass&) const {}
  void operator()(const Ggx& m) const {
    reflects(m.spectrum);
    out.push_back(verdict_on_roughness({m.alpha}));
  }
  void operator()(const RoughGlass& m) const { out.push_back(verdict_on_roughness({m.alpha})); }
  void operator()(const Emission&) const {}
  void operator()(const Conductor& m) const {
    if (is_measured(m))
      out.push_back({Effect::MeasuredMetal, true, "has n and k that differ from wavelength to wavelength"});
    else
      out.push_back({Effect::MeasuredMetal, false, "has the same n and k at all wavelengths"});
    if (m.roughness) out.push_back(verdict_on_roughness(*m.roughness));
    if (auto verdict = verdict_on_film(m)) out.push_back(std::move(*verdict));
  }
  void operator()(const Dielectric& m) const {
    const double span = ratio_of(m.index, m.outside).span();
    if (span > kLeastDispersion)
      out.push_back({Effect::Dispersion, true, fmt::format("has an index that varies by {:.3g}", span)});
    else if (span > 0)
      out.push_back({Effect::Dispersion, false,
                     fmt::format("has an index that varies by {:.3g}, which is less than {:g}", span,
                                 kLeastDispersion)});
    else
      out.push_back({Effect::Dispersion, false, "has the same index at all wavelengths"});
    if (m.roughness) out.push_back(verdict_on_roughness(*m.roughness));
    if (auto verdict = verdict_on_film(m)) out.push_back(std::move(*verdict));
  }
  void operator()(const Polariser&) const { out.push_back({Effect::Polarisation, true, "is a polariser"}); }
  void operator()(const Retarder& m) const {
    const bool does_nothing = std::fmod(m.retardance_deg, 360) == 0;
    out.push_back({Effect::Polarisation, !does_nothing,
                   does_nothing ? fmt::format("retards by {} degrees, whole waves", m.retardance_deg)
                                : fmt::format("retards by {} degrees", m.retardance_deg)});
  }
  void operator()(const Fluorescent& m) const {
    reflects(m.spectrum);
    if (const auto support = support_of(m.reradiation))
      out.push_back({Effect::Fluorescence, true,
                     fmt::format("turns light of {:g} to {:g} nm into light of {:g} to {:g} nm{}",
                                 support->in.first_nm, support->in.last_nm, support->out.first_nm,
                                 support->out.last_nm, m.gains_energy ? " and gains energy" : "")});
    else
      out.push_back({Effect::Fluorescence, false, "has a kernel that is zero: it re-radiates nothing"});
  }

  void reflects(const std::optional<SpectrumUse>& use) const {
    if (use) out.push_back(verdict_on_reflectance(scene, *use));
  }
};

struct Coloured {
  const Scene& scene;

  bool operator()(const Conductor& m) const { return is_measured(m) || shows_film(m); }
  bool operator()(const Dielectric& m) const { return is_dispersive(m) || shows_film(m); }
  bool operator()(const Polariser&) const { return false; }
  bool operator()(const Retarder&) const { return false; }
  bool operator()(const Emission&) const { return false; }
  bool operator()(const Fluorescent& m) const {
    return support_of(m.reradiation) || by(m.reflectance, m.spectrum);
  }
  bool operator()(const Lambert& m) const { return m.texture || by(m.reflectance, m.spectrum); }
  bool operator()(const OrenNayar& m) const { return m.texture || by(m.reflectance, m.spectrum); }
  bool operator()(const Mirror& m) const { return by(m.reflectance, m.spectrum); }
  bool operator()(const Ggx& m) const { return by(m.colour, m.spectrum); }
  bool operator()(const Glass& m) const { return !is_grey(m.colour); }
  bool operator()(const RoughGlass& m) const { return !is_grey(m.colour); }

  bool by(RgbColour rgb, const std::optional<SpectrumUse>& use) const {
    return use ? use->scale > 0 && !is_constant(named(scene, *use).spectrum) : !is_grey(rgb);
  }
};

bool is_d65(const Spectrum& light) {
  const auto& d65 = spectra::illuminant("D65");
  constexpr double kRounding = 1e-9;
  const double scale = value_at(light, 560) / value_at(d65, 560);
  auto wavelengths_nm = wavelengths_of({});
  wavelengths_nm.insert(wavelengths_nm.end(), light.wavelengths_nm.begin(), light.wavelengths_nm.end());
  return std::all_of(wavelengths_nm.begin(), wavelengths_nm.end(), [&](double nm) {
    return std::fabs(value_at(light, nm) - scale * value_at(d65, nm)) <= kRounding * scale;
  });
}

bool is_dark(const Spectrum& light) {
  return std::all_of(light.values.begin(), light.values.end(), [](double value) { return value == 0; });
}

}  // namespace

bool is_dispersive(const Dielectric& glass) {
  return ratio_of(glass.index, glass.outside).span() > kLeastDispersion;
}

std::vector<EffectVerdict> verdicts_on(const Scene& scene, const MaterialModel& model) {
  std::vector<EffectVerdict> out;
  std::visit(ModelVerdicts{scene, out}, model);
  if (texture_of(model)) out.push_back({Effect::Texture, true, "has a texture"});
  return out;
}

bool is_coloured(const Scene& scene, const MaterialModel& model) {
  return std::visit(Coloured{scene}, model);
}

EffectVerdict verdict_on_light(const Scene& scene, const SpectrumUse& use, bool has_coloured_surface) {
  const auto& [name, spectrum] = named(scene, use);
  if (use.scale == 0 || is_dark(spectrum)) return {Effect::Spectral, false, "gives no light"};
  if (is_d65(spectrum))
    return {Effect::Spectral, false,
            fmt::format("has spectrum '{}', which is D65: white says the same", name)};
  if (!has_coloured_surface)
    return {Effect::Spectral, false,
            fmt::format("has spectrum '{}', but every surface treats all wavelengths alike: the colour of "
                        "the light says it all",
                        name)};
  return {Effect::Spectral, true, fmt::format("gives light by spectrum '{}', which is not D65", name)};
}

}  // namespace orbs::scene
