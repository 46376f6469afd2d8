#include "tracer_cli/options.h"

#include "base/error.h"
#include "base/terminal.h"
#include "command_line/command.h"
#include "command_line/manual.h"
#include "scene/effects/effects.h"
#include "scene/render_fault.h"
#include "tracer_cli/faulty_program.h"

#include <string_view>
#include <vector>

#include <fmt/format.h>

namespace orbs::tracer_cli {

namespace {

std::vector<std::string> transport_choices() {
  std::vector<std::string> choices{"auto"};
  for (const auto transport : scene::kTransports) choices.emplace_back(scene::transport_name(transport));
  return choices;
}

// What is rendered, and how large and how well.
void add_image_options(const command_line::Command& app, Options& options) {
  app.add_option("scene", options.scene, "scene file (orbs-scene/1)").required();
  app.add_option("-o,--output", options.output, "image to write (OpenEXR: R,G,B and their variances)")
      .required();
  app.add_option("--spp", options.render.samples_per_pixel, "samples per pixel")
      .range(1, 1 << 24)
      .shows_default();
  app.add_option("--seed", options.render.seed,
                 "seed of the random numbers; the same seed gives the same image")
      .shows_default();
  app.add_option("--threads", options.render.threads,
                 "number of threads, 0: all cores; the image does not depend on it")
      .range(0, 1024)
      .shows_default();
  app.add_option("--width", options.width, "replaces the camera's width, in pixels").range(1, 65536);
  app.add_option("--height", options.height, "replaces the camera's height, in pixels").range(1, 65536);
  app.add_flag("--split-paths", options.render.split_paths,
               "write one layer per class of light path (path.EDSL.R ...)");
  app.add_option("--camera", options.camera,
                 "one of the \"cameras\" of the scene, by its name (default: its \"camera\")");
  app.add_option(
         "--plugin", options.plugins.files,
         "shared library with shapes that scenes may name (docs/use/plug-ins.md), by the name of its file; "
         "may be given several times")
      .one_value_each();
  app.add_option("--plugin-folder", options.plugins.folder,
                 "folder in which the plug-ins that a scene names are looked for, if no --plugin is meant")
      .existing_folder();
}

// The algorithms, in the order of the help text. Their expected image is the same.
void add_algorithm_options(const command_line::Command& app, Options& options) {
  app.add_option("--sampler", options.sampler,
                 "random numbers: independent, stratified (jittered) or sobol (Owen-scrambled)")
      .one_of({"independent", "stratified", "sobol"})
      .shows_default();
  app.add_option(
         "--direct-light", options.direct_light,
         "light that comes straight from emitters: mis (light and BSDF sampling, multiple importance "
         "sampling), light (next-event estimation alone, but where it cannot find the light) or bsdf (no "
         "next-event estimation)")
      .one_of({"mis", "light", "bsdf"})
      .shows_default();
  app.add_option("--light-selection", options.light_selection,
                 "which of several emitters light sampling takes: bvh (by what each may contribute to the "
                 "point), learned (also by what trial light samples have met in its region), power (by its "
                 "power alone) or auto (what a trial rendering shows to be better)")
      .one_of({"auto", "bvh", "learned", "power"})
      .shows_default();
  app.add_option(
         "--light-paths", options.light_paths,
         "light tracing for caustics: auto (if a trial rendering shows that it reduces noise), always "
         "or never")
      .one_of({"auto", "always", "never"})
      .shows_default();
  app.add_option("--light-connections", options.light_connections,
                 "connections of camera paths to the first hits of light paths (bidirectional): auto (if a "
                 "trial rendering shows that they reduce noise), always or never")
      .one_of({"auto", "always", "never"})
      .shows_default();
  app.add_option(
         "--intersection", options.intersection,
         "arithmetic of the tests of rays against triangles: single (Embree's own) or double (slower; "
         "the difference of both images shows where rounding decides)")
      .one_of({"single", "double"})
      .shows_default();
  app.add_flag("--no-mirrored-light", options.has_no_mirrored_light,
               "no next-event estimation by way of flat mirrors");
  app.add_flag("--no-variances", options.has_no_variances,
               "no pixel is rendered a second time to learn the noise, and the image has no variances");
  app.add_flag("--no-roulette", options.has_no_roulette,
               "no Russian roulette: paths end at the trace depth or where they carry no light");
}

// Unlike the algorithms these change the expected image: an irradiance cache is biased.
void add_integrator_options(const command_line::Command& app, Options& options) {
  app.add_option("--integrator", options.integrator,
                 "scene (the one that the scene names), path (path tracing) or irradiance_cache (biased: "
                 "diffuse interreflection is interpolated between a few places)")
      .one_of({"scene", "path", "irradiance_cache"})
      .shows_default();
  app.add_option(
         "--cache-error", options.cache_error,
         "replaces the error of Ward's metric that the scene gives its irradiance cache: less is more "
         "accurate")
      .range(1e-3, 10.0);
  app.add_option("--cache-rays", options.cache_rays,
                 "replaces the number of rays of each record of the irradiance cache")
      .range(8, 4096);
}

void add_transport_options(const command_line::Command& app, Options& options) {
  app.add_option("--transport", options.transport,
                 "what light paths carry: auto (the cheapest that has what the scene calls for), or one that "
                 "has more; the expected image is the same")
      .one_of(transport_choices())
      .shows_default();
  app.add_flag("--lossy", options.may_lose_effects,
               "permit a transport that lacks effects that the scene calls for; the image lacks them, too");
}

// "test a suite: normals-by-matrix (...), ...".
std::string fault_help() {
  std::string text =
      "make a mistake on purpose, to see whether the gates of a suite reject its images; the image's "
      "attribute orbs.fault names it:";
  for (const auto& one : scene::kRenderFaults)
    text += fmt::format("{} {} ({})", one.fault == scene::kRenderFaults.front().fault ? "" : ",", one.name,
                        one.what);
  return text;
}

// A plain path tracer, as most of those that have such faults are.
void add_fault(const Options& options, tracer::WorldSettings& settings) {
  settings.fault = scene::render_fault_named(options.fault);
  if (settings.fault != scene::RenderFault::NoMisWeight) return;
  settings.direct_light = tracer::DirectLight::Unweighted;
  settings.light_paths = false;
  settings.mirrored_light = false;
}

tracer::Sampler sampler_named(const std::string& name) {
  using tracer::Sampler;
  if (name == "independent") return Sampler::Independent;
  return name == "stratified" ? Sampler::Stratified : Sampler::Sobol;
}

tracer::DirectLight direct_light_named(const std::string& name) {
  using tracer::DirectLight;
  if (name == "light") return DirectLight::Light;
  return name == "bsdf" ? DirectLight::Bsdf : DirectLight::Mis;
}

}  // namespace

Options parse_options(int argc, char** argv, const std::string& version) {
  Options options;
  const command_line::Program program("orbs-tracer",
                                      "Renders one orbs-scene/1 file with the reference path tracer.",
                                      "orbs-tracer " + version);
  const auto app = program.command();
  add_image_options(app, options);
  add_algorithm_options(app, options);
  add_integrator_options(app, options);
  add_transport_options(app, options);
  auto faults = scene::render_fault_names();
  for (const auto& name : numeric_fault_names()) faults.push_back(name);
  app.add_option("--fault", options.fault, fault_help()).one_of(faults);
  app.add_option(
         "--bad-samples", options.bad_samples,
         "where more than 100 in a million samples came out as no finite number and are left out, or as many "
         "rays met shapes that did not answer: fail (exit status 4, with the image written) or count (the "
         "image's attributes alone say so)")
      .one_of({"fail", "count"})
      .shows_default();
  app.add_flag("--json", options.as_json, "print progress on standard output, one JSON object per line");
  // No option of its own: it would ask for a scene. The package has the page.
  if (argc == 2 && std::string_view(argv[1]) == "--manual") {
    print_raw(stdout,
              command_line::manual_page(app, "orbs-tracer", "reference path tracer of orbs", version));
    std::exit(0);
  }
  const auto parsed = program.parse(argc, argv);
  if (!parsed.problem.empty()) {
    print_clean(stderr, "{}\nRun with --help for more information.\n", parsed.problem);
    std::exit(2);
  }
  if (!parsed.text.empty()) {
    print_clean("{}", parsed.text);
    std::exit(0);
  }
  tracer::check_plugin_names(options.plugins);
  return options;
}

void set_integrator(scene::Scene& scene, const Options& options) {
  if (options.integrator == "path") scene.integrator = scene::PathTracing{};
  if (options.integrator == "irradiance_cache" &&
      !std::holds_alternative<scene::IrradianceCache>(scene.integrator))
    scene.integrator = scene::IrradianceCache{};
  auto* cache = std::get_if<scene::IrradianceCache>(&scene.integrator);
  if (cache == nullptr) {
    if (options.cache_error > 0 || options.cache_rays > 0)
      throw InputError(
          "--cache-error and --cache-rays are settings of an irradiance cache, and the image has none: add "
          "--integrator irradiance_cache, or leave them out");
    return;
  }
  if (options.cache_error > 0 && cache->metric != scene::CacheMetric::Ward)
    throw InputError(
        "--cache-error is a setting of Ward's metric, and the scene asks for that of Tabellion and Lamorlette");
  if (options.render.split_paths)
    throw InputError("--split-paths: an irradiance cache keeps no light paths that have classes");
  if (options.cache_error > 0) cache->error = options.cache_error;
  if (options.cache_rays > 0) cache->rays = options.cache_rays;
}

tracer::RenderSettings render_settings(const Options& options, const scene::Scene& scene) {
  auto settings = options.render;
  settings.sampler = sampler_named(options.sampler);
  settings.variances = !options.has_no_variances;
  settings.split_paths = settings.split_paths || scene.outputs.path_classes;
  return settings;
}

tracer::WorldSettings world_settings(const Options& options, const scene::Scene& scene) {
  using tracer::Intersection;
  using tracer::LightSelection;
  tracer::WorldSettings settings{
      .transport = scene::transport_named(options.transport),
      .may_lose_effects = options.may_lose_effects,
      .light_paths = options.light_paths != "never",
      .mirrored_light = !options.has_no_mirrored_light,
      .direct_light = direct_light_named(options.direct_light),
      .light_selection = options.light_selection == "power" ? LightSelection::Power : LightSelection::Bvh,
      .roulette = !options.has_no_roulette,
      .intersection = options.intersection == "double" ? Intersection::Double : Intersection::Single,
      .plugins = tracer::open_plugins(scene, options.plugins)};
  add_fault(options, settings);
  return settings;
}

std::vector<std::string> ignored_options(const Options& options, const tracer::World& world) {
  std::vector<std::string> ignored;
  const auto add = [&](const char* option, const std::string& setting, const std::string& why) {
    if (setting == "always" && !why.empty())
      ignored.push_back(fmt::format(
          "{0} always has no effect: {1}. The image is right without; where it is noisy, give more samples",
          option, why));
  };
  add("--light-paths", options.light_paths, tracer::why_no_light_paths(world));
  add("--light-connections", options.light_connections, tracer::why_no_light_connections(world));
  return ignored;
}

}  // namespace orbs::tracer_cli
