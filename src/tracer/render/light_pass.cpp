#include "tracer/render/light_pass.h"

namespace orbs::tracer {

void add_splats(const std::vector<Splat>& splats, double share, Film& film, BadSamples& bad) {
  for (const Splat& splat : splats) {
    if (!is_finite(splat.value)) {
      merge(bad, {1, static_cast<int>(splat.pixel) % film.width, static_cast<int>(splat.pixel) / film.width});
      continue;
    }
    const Vec3d radiance = cast<double>(splat.value) * share;
    film.pixels[splat.pixel].current += radiance;
    if (!film.class_sums.empty())
      film.class_sums[static_cast<std::size_t>(splat.path_class)][splat.pixel] += radiance;
  }
}

}  // namespace orbs::tracer
