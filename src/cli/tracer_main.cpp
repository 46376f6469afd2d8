#include "base/error.h"
#include "base/files.h"
#include "base/terminal.h"
#include "image/image_io.h"
#include "scene/effects.h"
#include "scene/load_scene.h"
#include "tracer/choose_light_connections.h"
#include "tracer/choose_light_paths.h"
#include "tracer/choose_light_selection.h"
#include "tracer/render.h"
#include "tracer/world/build_world.h"

#include <atomic>
#include <csignal>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <unistd.h>

#ifndef ORBS_VERSION
#  define ORBS_VERSION "unknown"
#endif

namespace {

std::atomic<bool> stop{false};

extern "C" void request_stop(int) { stop = true; }

struct Options {
  std::string scene;
  std::string output;
  int width = 0;  // 0: as in the scene
  int height = 0;
  bool as_json = false;
  orbs::tracer::RenderSettings render;
  std::string light_paths = "auto";
  std::string light_connections = "auto";
  std::string direct_light = "mis";
  std::string sampler = "sobol";
  std::string light_selection = "auto";
  std::string intersection = "single";
  std::string integrator = "scene";
  double cache_error = 0;  // 0: as in the scene
  int cache_rays = 0;      // 0: as in the scene
  bool has_no_roulette = false;
  bool has_no_mirrored_light = false;
  /// Nothing: the cheapest that has what the scene calls for.
  std::optional<orbs::scene::LightTransport> transport;
  bool may_lose_effects = false;
};

std::vector<std::string> transport_choices() {
  std::vector<std::string> choices{"auto"};
  for (const auto transport : orbs::scene::kTransports)
    choices.emplace_back(orbs::scene::transport_name(transport));
  return choices;
}

// The algorithms, in the order of the help text. Their expected image is the same.
void add_algorithm_options(CLI::App& app, Options& options) {
  app.add_option("--sampler", options.sampler,
                 "random numbers: independent, stratified (jittered) or sobol (Owen-scrambled)")
      ->check(CLI::IsMember({"independent", "stratified", "sobol"}))
      ->capture_default_str();
  app.add_option(
         "--replicates", options.render.replicates,
         "least number of independent blocks of points per pixel, from which its variance is estimated; "
         "1: one block has all points, and the image has no variances")
      ->check(CLI::Range(1, 1 << 16))
      ->capture_default_str();
  app.add_option(
         "--direct-light", options.direct_light,
         "light that comes straight from emitters: mis (light and BSDF sampling, multiple importance "
         "sampling), light (next-event estimation alone, but where it cannot find the light) or bsdf (no "
         "next-event estimation)")
      ->check(CLI::IsMember({"mis", "light", "bsdf"}))
      ->capture_default_str();
  app.add_option("--light-selection", options.light_selection,
                 "which of several emitters light sampling takes: bvh (by what each may contribute to the "
                 "point), power (by its power alone) or auto (what a trial rendering shows to be better)")
      ->check(CLI::IsMember({"auto", "bvh", "power"}))
      ->capture_default_str();
  app.add_option(
         "--light-paths", options.light_paths,
         "light tracing for caustics: auto (if a trial rendering shows that it reduces noise), always "
         "or never")
      ->check(CLI::IsMember({"auto", "always", "never"}))
      ->capture_default_str();
  app.add_option("--light-connections", options.light_connections,
                 "connections of camera paths to the first hits of light paths (bidirectional): auto (if a "
                 "trial rendering shows that they reduce noise), always or never")
      ->check(CLI::IsMember({"auto", "always", "never"}))
      ->capture_default_str();
  app.add_option(
         "--intersection", options.intersection,
         "arithmetic of the tests of rays against triangles: single (Embree's own) or double (slower; "
         "the difference of both images shows where rounding decides)")
      ->check(CLI::IsMember({"single", "double"}))
      ->capture_default_str();
  app.add_flag("--no-mirrored-light", options.has_no_mirrored_light,
               "no next-event estimation by way of flat mirrors");
  app.add_flag("--no-roulette", options.has_no_roulette,
               "no Russian roulette: paths end at the trace depth or where they carry no light");
}

// Unlike the algorithms these change the expected image: an irradiance cache is biased.
void add_integrator_options(CLI::App& app, Options& options) {
  app.add_option("--integrator", options.integrator,
                 "scene (the one that the scene names), path (path tracing) or irradiance_cache (biased: "
                 "diffuse interreflection is interpolated between a few places)")
      ->check(CLI::IsMember({"scene", "path", "irradiance_cache"}))
      ->capture_default_str();
  app.add_option(
         "--cache-error", options.cache_error,
         "replaces the error of Ward's metric that the scene gives its irradiance cache: less is more "
         "accurate")
      ->check(CLI::Range(1e-3, 10.0));
  app.add_option("--cache-rays", options.cache_rays,
                 "replaces the number of rays of each record of the irradiance cache")
      ->check(CLI::Range(8, 4096));
}

orbs::tracer::Sampler sampler_named(const std::string& name) {
  using orbs::tracer::Sampler;
  if (name == "independent") return Sampler::Independent;
  return name == "stratified" ? Sampler::Stratified : Sampler::Sobol;
}

orbs::tracer::DirectLight direct_light_named(const std::string& name) {
  using orbs::tracer::DirectLight;
  if (name == "light") return DirectLight::Light;
  return name == "bsdf" ? DirectLight::Bsdf : DirectLight::Mis;
}

Options parse_options(int argc, char** argv) {
  Options options;
  CLI::App app{"Renders one orbs-scene/1 file with the reference path tracer."};
  app.set_version_flag("--version", "orbs-tracer " ORBS_VERSION);
  app.add_option("scene", options.scene, "scene file (orbs-scene/1)")->required();
  app.add_option("-o,--output", options.output, "image to write (OpenEXR: R,G,B and their variances)")
      ->required();
  app.add_option("--spp", options.render.samples_per_pixel, "samples per pixel")
      ->check(CLI::Range(1, 1 << 24))
      ->capture_default_str();
  app.add_option("--seed", options.render.seed,
                 "seed of the random numbers; the same seed gives the same image")
      ->capture_default_str();
  app.add_option("--threads", options.render.threads,
                 "number of threads, 0: all cores; the image does not depend on it")
      ->check(CLI::Range(0, 1024))
      ->capture_default_str();
  app.add_option("--width", options.width, "replaces the camera's width, in pixels")
      ->check(CLI::Range(1, 65536));
  app.add_option("--height", options.height, "replaces the camera's height, in pixels")
      ->check(CLI::Range(1, 65536));
  app.add_flag("--split-paths", options.render.split_paths,
               "write one layer per class of light path (path.EDSL.R ...)");
  add_algorithm_options(app, options);
  add_integrator_options(app, options);
  std::string transport = "auto";
  app.add_option("--transport", transport,
                 "what light paths carry: auto (the cheapest that has what the scene calls for), or one that "
                 "has more; the expected image is the same")
      ->check(CLI::IsMember(transport_choices()))
      ->capture_default_str();
  app.add_flag("--lossy", options.may_lose_effects,
               "permit a transport that lacks effects that the scene calls for; the image lacks them, too");
  app.add_flag("--json", options.as_json, "print progress on standard output, one JSON object per line");
  try {
    app.parse(argc, argv);
    if (app.count("--replicates") > 0 && options.render.replicates > options.render.samples_per_pixel)
      throw orbs::InputError(fmt::format(
          "--replicates {} need as many samples, and --spp is {}: raise it, or give fewer replicates",
          options.render.replicates, options.render.samples_per_pixel));
  } catch (const CLI::ParseError& e) {
    std::exit(app.exit(e) == 0 ? 0 : 2);
  }
  options.transport = orbs::scene::transport_named(transport);
  return options;
}

// Shows the progress. It is called after every tile and prints at most ten times a second.
class ProgressLine {
 public:
  explicit ProgressLine(bool as_json) : as_json_(as_json), on_terminal_(::isatty(STDERR_FILENO) == 1) {}

  void show(const orbs::tracer::Progress& progress) {
    constexpr double kInterval = 0.1;  // seconds
    if (progress.seconds < last_seconds_ + kInterval) return;
    last_seconds_ = progress.seconds;
    if (as_json_) {
      orbs::print_clean("{{\"progress\": {:.4f}, \"spp\": {}, \"seconds\": {:.2f}}}\n", progress.done,
                        progress.samples_per_pixel, progress.seconds);
      std::fflush(stdout);
    } else if (on_terminal_) {
      constexpr int kWidth = 40;
      const auto full = static_cast<std::size_t>(progress.done * kWidth);
      const double left = progress.seconds / progress.done - progress.seconds;
      orbs::print_raw(
          stderr, fmt::format("\r[{}{}] {:3.0f} %  {:.0f} s, {:.0f} s left ", std::string(full, '#'),
                              std::string(kWidth - full, '.'), 100 * progress.done, progress.seconds, left));
    }
  }
  void finish() const {
    if (on_terminal_ && !as_json_ && last_seconds_ > 0) orbs::print_raw(stderr, fmt::format("\r{:79}\r", ""));
  }

 private:
  bool as_json_;
  bool on_terminal_;
  double last_seconds_ = 0;
};

void stamp_cache(orbs::tracer::Rendering& rendering, const orbs::scene::IrradianceCache& cache) {
  auto& header = rendering.image.attributes;
  const bool is_ward = cache.metric == orbs::scene::CacheMetric::Ward;
  header["orbs.integrator"] = "irradiance_cache";
  header["orbs.biased"] = "irradiance cache";
  header["orbs.variance"] = "left out: an irradiance cache is biased, and its pixels err together";
  header["orbs.cache_metric"] = is_ward ? fmt::format("ward, error {}", cache.error)
                                        : fmt::format("tabellion_lamorlette, kappa {}", cache.kappa);
  header["orbs.cache_rays"] = std::to_string(cache.rays);
  header["orbs.cache_records"] = std::to_string(rendering.cache_use.records);
  header["orbs.cache_lookups"] = std::to_string(rendering.cache_use.lookups);
  header["orbs.cache_uncovered"] = std::to_string(rendering.cache_use.uncovered);
  header["orbs.cache_negative"] = std::to_string(rendering.cache_use.negative);
}

// Nothing in the header depends on the machine, the time or the number of threads, so the same seed gives the
// same bytes.
void stamp(orbs::tracer::Rendering& rendering,
           const Options& options,
           const orbs::scene::Scene& scene,
           const orbs::tracer::World& world) {
  auto& header = rendering.image.attributes;
  header["orbs.program"] = "orbs-tracer";
  header["orbs.version"] = ORBS_VERSION;
  header["orbs.scene"] = scene.name;
  header["orbs.scene_hash"] = orbs::hash_text(orbs::content_hash(orbs::read_file(options.scene)));
  header["orbs.spp"] = std::to_string(rendering.samples_per_pixel);
  header["orbs.seed"] = std::to_string(options.render.seed);
  header["orbs.trace_depth"] = std::to_string(scene.trace_depth);
  header["orbs.sampler"] = options.sampler;
  header["orbs.replicates"] = std::to_string(options.render.replicates);
  header["orbs.direct_light"] = options.direct_light;
  header["orbs.light_selection"] = world.light_bvh.empty() ? "power" : "bvh";
  header["orbs.intersection"] = options.intersection;
  header["orbs.roulette"] = world.roulette ? "yes" : "no";
  header["orbs.mirrored_light"] = world.mirror_planes.empty() ? "no" : "yes";
  header["orbs.light_paths"] = world.caustic_casters.empty() ? "no" : "yes";
  header["orbs.light_connections"] = world.connects_light_vertices ? "yes" : "no";
  header["orbs.transport"] = std::string(orbs::scene::transport_name(world.transport));
  if (world.wants_stokes)
    header["orbs.stokes"] =
        "S0 to S3 in the frame of the image, for a viewer who faces the source: S1 > 0 horizontal, S2 > 0 at "
        "+45 degrees (right and up), S3 > 0 right-circular (the field rotates clockwise)";
  if (world.irradiance_cache) stamp_cache(rendering, *world.irradiance_cache);
  if (!world.solids.empty()) {
    const auto counts = orbs::tracer::root_counts(world.solids);
    header["orbs.undecided_roots"] = std::to_string(counts.undecided);
    header["orbs.unfinished_roots"] = std::to_string(counts.unfinished);
  }
  if (rendering.variance_leaves_floats) header["orbs.variance"] = "left out: beyond the range of floats";
  header["orbs.bad_samples"] = std::to_string(rendering.bad_samples.count);
}

// Replaces the integrator of the scene, or its settings.
void set_integrator(orbs::scene::Scene& scene, const Options& options) {
  if (options.integrator != "scene") scene.ambient_occlusion.reset();
  if (options.integrator == "path") scene.irradiance_cache.reset();
  if (options.integrator == "irradiance_cache" && !scene.irradiance_cache) scene.irradiance_cache.emplace();
  if (!scene.irradiance_cache) {
    if (options.cache_error > 0 || options.cache_rays > 0)
      throw orbs::InputError(
          "--cache-error and --cache-rays are settings of an irradiance cache, and the image has none: add "
          "--integrator irradiance_cache, or leave them out");
    return;
  }
  if (options.cache_error > 0 && scene.irradiance_cache->metric != orbs::scene::CacheMetric::Ward)
    throw orbs::InputError(
        "--cache-error is a setting of Ward's metric, and the scene asks for that of Tabellion and Lamorlette");
  if (options.render.split_paths)
    throw orbs::InputError("--split-paths: an irradiance cache keeps no light paths that have classes");
  if (options.cache_error > 0) scene.irradiance_cache->error = options.cache_error;
  if (options.cache_rays > 0) scene.irradiance_cache->rays = options.cache_rays;
}

void print_summary(const orbs::tracer::Rendering& r, bool as_json) {
  if (r.variance_leaves_floats)
    orbs::print_clean(
        stderr,
        "orbs-tracer: warning: the variances are beyond the range of floats, so the image has none; "
        "radiances between 1e-16 and 1e19 have them\n");
  if (r.bad_samples.count > 0)
    orbs::print_clean(
        stderr, "orbs-tracer: {} samples were not finite and are left out; the first one at pixel ({}, {})\n",
        r.bad_samples.count, r.bad_samples.first_x, r.bad_samples.first_y);
  if (as_json)
    orbs::print_clean(
        "{{\"progress\": 1, \"spp\": {}, \"render_seconds\": {:.4f}, \"cpu_seconds\": {:.4f}, "
        "\"traversal_seconds\": {:.4f}, \"bad_samples\": {}}}\n",
        r.samples_per_pixel, r.seconds, r.cpu_seconds, r.traversal_seconds, r.bad_samples.count);
  orbs::print_clean("orbs: render_seconds {:.4f}\n", r.seconds);
}

int run(const Options& options) {
  using namespace orbs;
  auto scene = scene::load_scene(options.scene);
  for (const auto& warning : scene.notes.warnings)
    orbs::print_clean(stderr, "orbs-tracer: warning: {}\n", warning);
  set_integrator(scene, options);
  if (options.width > 0) scene.camera.width_px = options.width;
  if (options.height > 0) scene.camera.height_px = options.height;
  auto world = tracer::make_world(
      scene, {.transport = options.transport,
              .may_lose_effects = options.may_lose_effects,
              .light_paths = options.light_paths != "never",
              .mirrored_light = !options.has_no_mirrored_light,
              .direct_light = direct_light_named(options.direct_light),
              .light_selection = options.light_selection == "power" ? tracer::LightSelection::Power
                                                                    : tracer::LightSelection::Bvh,
              .roulette = !options.has_no_roulette,
              .intersection = options.intersection == "double" ? tracer::Intersection::Double
                                                               : tracer::Intersection::Single});
  if (options.light_selection == "auto") tracer::choose_light_selection(world, options.render.threads);
  if (options.light_paths == "auto") tracer::choose_light_paths(world, options.render.threads);
  if (options.light_connections == "auto") tracer::choose_light_connections(world, options.render.threads);
  if (options.light_connections == "always")
    world.connects_light_vertices = tracer::supports_light_connections(world);
  // What the trial rendering met is no part of the image.
  for (auto& solid : world.solids) solid.counts = std::make_unique<tracer::RootCounts>();
  std::signal(SIGINT, request_stop);
  std::signal(SIGTERM, request_stop);
  ProgressLine line(options.as_json);
  auto settings = options.render;
  settings.sampler = sampler_named(options.sampler);
  settings.split_paths = settings.split_paths || scene.outputs.path_classes;
  auto rendering = tracer::render(world, settings, stop, [&](const tracer::Progress& p) { line.show(p); });
  line.finish();
  stamp(rendering, options, scene, world);
  image::write_exr(rendering.image, options.output);
  print_summary(rendering, options.as_json);
  if (rendering.samples_per_pixel == options.render.samples_per_pixel) return 0;
  orbs::print_clean(stderr,
                    "orbs-tracer: stopped after {} of {} samples per pixel; {} holds what was finished\n",
                    rendering.samples_per_pixel, options.render.samples_per_pixel, options.output);
  return kInterrupted;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(parse_options(argc, argv));
  } catch (const orbs::InputError& e) {
    orbs::print_clean(stderr, "orbs-tracer: {}\n", e.what());
    return 2;
  } catch (const std::exception& e) {
    orbs::print_clean(stderr, "orbs-tracer: internal error: {}\n", e.what());
    return 3;
  }
}
