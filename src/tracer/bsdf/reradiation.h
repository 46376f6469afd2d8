#pragma once

#include "spectra/rgb.h"
#include "tracer/integrator/make_bsdf.h"
#include "tracer/bsdf/broadcast.h"

#include <algorithm>

namespace orbs::tracer {

/// The wavelengths at which light that leaves with the path's was absorbed, and what the choice counts for.
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
    // No scene has light of shorter wavelengths.
    if (found.pdf == 0 || found.absorbed_nm < spectra::kShortestLight_nm) continue;
    out.nm[i] = static_cast<float>(found.absorbed_nm);
    out.weight[i] = static_cast<float>(found.weight);
  }
  return out;
}

/// A fluorescent surface, for a path that comes from the camera: either it goes on with its wavelengths and
/// finds light that was reflected, or with those at which the light that it would have found was absorbed.
/// The chances are in proportion to what the two bring, so that no weight exceeds the number of wavelengths
/// times both together. All four wavelengths stay in step, for the direction depends on none. Returns the
/// factor that Lambert's law is to be multiplied by. (Wilkie et al. 2001; Mojzik et al. 2018, "Handling
/// Fluorescence in a Uni-directional Spectral Path Tracer".)
template <Transport T>
Float4 reradiate(const World& world,
                 const Colour& colour,
                 const scene::Reradiation& kernel,
                 const ShadingContext<T>& context) {
  const Float4 reflected = T::reflectance(world, colour, context.lambda);
  const auto u = draw(context.block, context.index, context.bounce, SampleDimension::Reradiation);
  const Absorbed absorbed = absorbed_before(kernel, context.lambda.nm, u[1]);
  const float by_reflection = T::mean_of(reflected);
  const float by_reradiation = T::mean_of(absorbed.weight);
  if (by_reradiation == 0) return reflected;
  const float probability = by_reradiation / (by_reflection + by_reradiation);
  if (u[0] >= probability) return reflected * (1 / (1 - probability));
  context.lambda.nm = absorbed.nm;
  context.lambda.basis = spectra::rgb_basis_at(absorbed.nm);
  return absorbed.weight * (1 / probability);
}

}  // namespace orbs::tracer
