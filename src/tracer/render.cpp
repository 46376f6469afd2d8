#include "tracer/render.h"

#include "base/random.h"
#include "tracer/integrator/path_class.h"
#include "tracer/kernels/kernels.h"
#include "tracer/render/passes.h"
#include "tracer/render/render_clock.h"
#include "tracer/render/variance.h"
#include "tracer/shapes/build_solids.h"

#include <algorithm>
#include <bit>
#include <span>
#include <vector>

namespace orbs::tracer {

namespace {

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
  if (!world.caustic_casters.empty()) film.splats = film.finished_splats = black;
  return film;
}

// Pixels that share records of the cache err together: what a replicate differs by says nothing of that.
bool has_variances(const World& world, const RenderSettings& settings) {
  return settings.variances && !std::holds_alternative<scene::IrradianceCache>(world.integrator);
}

void give_pieces(Film& film, int count) {
  const std::vector<std::vector<Vec3f>> black(static_cast<std::size_t>(count),
                                              std::vector<Vec3f>(film.pixels.size()));
  film.pieces = black;
  if (!film.splats.empty()) film.splat_pieces = black;
}

void end_pieces(Film& film) {
  for (std::size_t i = 0; i < film.pixels.size(); ++i)
    end_piece(film, i, static_cast<int>(film.pieces.size()));
}

// What a film has had at its end.
struct PassesDone {
  std::span<const Pass> passes;
  WholePieces pieces;
};

// Renders the replicates with the passes that the film has had, and adds the time to `out`.
std::vector<Vec3d> variances_by_replicates(
    const World& world, RenderSettings settings, const Film& film, PassesDone done, Rendering& out) {
  if (done.pieces.count < 2) return {};
  constexpr std::uint64_t kReplicateSeed = 0x7517;  // separates their random numbers from those of the image
  settings.seed = mix(settings.seed, kReplicateSeed);
  settings.split_paths = false;
  const std::vector<Vec3d> scatter = scatter_of(film.pieces, done.pieces.count);
  const std::vector<LikePixels> groups = like_pixels(film, scatter, settings.seed);
  Film replicates = film_of_replicates(film, groups);
  Rendering of_replicates;
  for (std::uint32_t p = 0; p < done.passes.size(); ++p)
    kernel_for(world)(world, settings, {p, done.passes[p]}, replicates, of_replicates, [] {});
  end_pieces(replicates);
  out.traversal_seconds += of_replicates.traversal_seconds;
  return variances_of_means(film, scatter, groups, replicates, done.pieces);
}

}  // namespace

Rendering render(const World& world,
                 const RenderSettings& settings,
                 const std::atomic<bool>& stop,
                 const std::function<void(const Progress&)>& report) {
  const RenderClock clock;
  Film film = film_for(world, settings);
  const bool wants_variances = has_variances(world, settings);
  Pieces pieces =
      wants_variances ? pieces_of(settings.samples_per_pixel) : Pieces{1, settings.samples_per_pixel};
  pieces.share_passes = film.splats.empty();
  const auto passes = plan_passes(settings.samples_per_pixel, pieces);
  give_pieces(film, wants_variances ? pieces.count : 0);
  const auto pixels = film.pixels.size();
  const double share_of_film =
      wants_variances ? static_cast<double>(pixels) / static_cast<double>(pixels + replicate_count(pixels))
                      : 1;
  PassRenderer* const render_pass = kernel_for(world);
  Rendering out;
  std::uint32_t done = 0;
  int finished_pieces = 0;
  for (; done < passes.size() && !(stop && done > 0); ++done) {
    int tiles_done = 0;
    render_pass(world, settings, {done, passes[done]}, film, out, [&] {
      const double share =
          (done + static_cast<double>(++tiles_done) / tile_count(film)) / static_cast<double>(passes.size());
      report({share * share_of_film, out.samples_per_pixel, clock.seconds()});
    });
    out.samples_per_pixel += static_cast<int>(passes[done].count);
    finished_pieces = passes[done].piece + static_cast<int>(passes[done].ended_pieces);
  }
  end_pieces(film);
  std::vector<Vec3d> variances;
  if (wants_variances) {
    const auto whole = static_cast<int>(std::bit_floor(static_cast<unsigned>(finished_pieces)));
    const double share = static_cast<double>(whole) * pieces.length / out.samples_per_pixel;
    variances = variances_by_replicates(
        world, settings, film, {std::span(passes).first(done), {std::min(whole, pieces.count), share}}, out);
  }
  refuse_unfinished_shapes(world.solids);
  drop_unused_classes(film);
  if (!variances.empty() && !float_holds_variances(film, variances)) {
    variances.clear();
    out.variance_leaves_floats = true;
  }
  out.image = resolve(film, variances);
  const RenderTime time = clock.time();
  out.seconds = time.seconds;
  out.cpu_seconds = time.cpu_seconds;
  return out;
}

}  // namespace orbs::tracer
