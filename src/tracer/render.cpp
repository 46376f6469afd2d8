#include "tracer/render.h"

#include "tracer/integrator/path_class.h"
#include "tracer/kernels/kernels.h"
#include "tracer/shapes/build_solids.h"

#include <algorithm>
#include <chrono>
#include <ctime>

namespace orbs::tracer {

namespace {

double cpu_seconds_now() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

// All classes have sums while rendering; classes that stay black get no layer in the image.
void drop_unused_classes(Film& film) {
  for (auto& sums : film.class_sums)
    if (std::all_of(sums.begin(), sums.end(), [](Vec3d v) { return v == Vec3d{}; })) sums.clear();
}

Film film_for(const World& world, const RenderSettings& settings) {
  Film film = make_film(world.camera.width, world.camera.height);
  const std::vector<Vec3d> black(film.pixels.size());
  if (settings.split_paths) film.class_sums.assign(PathClass::kCount, black);
  if (world.wants_stokes) film.stokes.assign(3, black);
  return film;
}

}  // namespace

Rendering render(const World& world,
                 const RenderSettings& settings,
                 const std::atomic<bool>& stop,
                 const std::function<void(const Progress&)>& report) {
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  const double cpu_start = cpu_seconds_now();
  const auto seconds = [&] { return std::chrono::duration<double>(Clock::now() - start).count(); };
  Film film = film_for(world, settings);
  const auto passes = plan_passes(settings.samples_per_pixel, settings.replicates);
  // Pixels that share records err together: the scatter of their samples says nothing of that.
  film.has_variance = !std::holds_alternative<scene::IrradianceCache>(world.integrator) &&
                      (settings.replicates > 1 || passes.back().replicate > 0);
  PassRenderer* const render_pass = kernel_for(world);
  Rendering out;
  for (std::uint32_t p = 0; p < passes.size() && !(stop && p > 0); ++p) {
    int tiles_done = 0;
    render_pass(world, settings, {p, passes[p]}, film, out, [&] {
      const double done =
          (p + static_cast<double>(++tiles_done) / tile_count(film)) / static_cast<double>(passes.size());
      report({done, out.samples_per_pixel, seconds()});
    });
    out.samples_per_pixel += static_cast<int>(passes[p].count);
  }
  refuse_unfinished_shapes(world.solids);
  for (PixelSums& pixel : film.pixels) end_replicate(pixel);
  drop_unused_classes(film);
  if (film.has_variance && !float_holds_variances(film)) {
    film.has_variance = false;
    out.variance_leaves_floats = true;
  }
  out.image = resolve(film);
  out.seconds = seconds();
  out.cpu_seconds = cpu_seconds_now() - cpu_start;
  return out;
}

}  // namespace orbs::tracer
