#pragma once

#include "spectra/rgb.h"
#include "tracer/bsdf/broadcast.h"
#include "tracer/bsdf/lambert.h"
#include "tracer/sampling/sampler.h"

#include <algorithm>

/// Lambert's law at every wavelength, and re-radiation at longer wavelengths.
namespace orbs::tracer {

struct FluorescentMaterial {
  static constexpr bool kIsAppearance = true;
  template <typename Value, std::size_t N>
  using Bsdfs = BsdfList<>;  // Lambert's
  Colour reflectance;
  scene::Reradiation reradiation;
};

inline FluorescentMaterial make_material(const scene::Fluorescent& m, const SceneColours& colours) {
  return {make_colour(colours, m.reflectance, m.spectrum), m.reradiation};
}

inline float lobe_alpha(const FluorescentMaterial&) { return kNoLobe; }

/// Wavelengths at which the light was absorbed that leaves at the wavelengths of the path, and the weight of
/// that choice (kernel / pdf).
struct Absorbed {
  std::array<float, 4> nm{};
  Float4 weight{};
};

inline Absorbed absorbed_before(const scene::Reradiation& kernel, const std::array<float, 4>& nm, float u) {
  Absorbed out{nm, {}};
  for (std::size_t i = 0; i < 4; ++i) {
    const auto found = std::visit(
        [&](const auto& k) { return sample_absorbed(k, static_cast<double>(nm[i]), static_cast<double>(u)); },
        kernel);
    // No scene emits light of shorter wavelengths.
    if (found.pdf == 0 || found.absorbed_nm < spectra::kShortestLight_nm) continue;
    out.nm[i] = static_cast<float>(found.absorbed_nm);
    out.weight[i] = static_cast<float>(found.weight);
  }
  return out;
}

/// Chooses for a path from the camera between reflection, which keeps its wavelengths, and re-radiation,
/// after which it looks for light at the wavelengths of absorption. The probabilities are proportional to
/// what the two contribute, so that no weight exceeds the number of wavelengths times their sum. All four
/// wavelengths make the same choice, because the direction depends on none of them. Returns the factor of
/// Lambert's law. (Wilkie et al. 2001; Mojzik et al. 2018, "Handling Fluorescence in a Uni-directional
/// Spectral Path Tracer".)
template <typename Context>
Float4 reradiate(const FluorescentMaterial& material, const Context& at) {
  const Float4 reflected = at.reflectance(material.reflectance);
  const auto u = at.draw(SampleDimension::Reradiation);
  const Absorbed absorbed = absorbed_before(material.reradiation, at.wavelengths_nm(), u[1]);
  const float by_reflection = mean_of(reflected);
  const float by_reradiation = mean_of(absorbed.weight);
  if (by_reradiation == 0) return reflected;
  const float probability = by_reradiation / (by_reflection + by_reradiation);
  if (u[0] >= probability) return reflected * (1 / (1 - probability));
  at.set_wavelengths_nm(absorbed.nm);
  return absorbed.weight * (1 / probability);
}

/// Transports that keep the wavelength render its reflectance alone: they are used if the kernel is zero, or
/// if fluorescence is to be left out.
template <typename Context>
void make_bsdf(typename Context::Bsdf& out, const FluorescentMaterial& material, const Context& at) {
  if constexpr (Context::kFluoresces)
    out = LambertBsdf<typename Context::Value>{reradiate(material, at)};
  else
    out = LambertBsdf<typename Context::Value>{at.reflectance(material.reflectance)};
}

}  // namespace orbs::tracer
