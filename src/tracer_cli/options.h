#pragma once

#include "scene/scene.h"
#include "tracer/plugins/plugin_library.h"
#include "tracer/render.h"
#include "tracer/world/build_world.h"

#include <string>
#include <vector>

namespace orbs::tracer_cli {

/// The command line of orbs-tracer.
struct Options {
  std::string scene;
  std::string camera;  // "": the one without a name
  std::string output;
  int width = 0;  // 0: as in the scene
  int height = 0;
  bool as_json = false;
  tracer::RenderSettings render;
  std::string light_paths = "auto";
  std::string light_connections = "auto";
  std::string direct_light = "mis";
  std::string sampler = "sobol";
  std::string light_selection = "auto";
  std::string intersection = "single";
  std::string integrator = "scene";
  double cache_error = 0;  // 0: as in the scene
  int cache_rays = 0;      // 0: as in the scene
  bool has_no_variances = false;
  bool has_no_roulette = false;
  bool has_no_mirrored_light = false;
  std::string transport = "auto";
  bool may_lose_effects = false;
  std::string fault;  // "": none
  std::string bad_samples = "fail";
  tracer::PluginSources plugins;

  bool only_counts_bad_samples() const { return bad_samples == "count"; }
};

/// Ends the process after --help and --version (exit status 0) and, with a message, after a command line that
/// is wrong (2). Throws InputError for options that contradict each other.
Options parse_options(int argc, char** argv, const std::string& version);

/// Replaces the integrator of the scene, or its settings. Throws InputError for settings of another
/// integrator.
void set_integrator(scene::Scene& scene, const Options& options);

tracer::RenderSettings render_settings(const Options& options, const scene::Scene& scene);

/// Opens the plug-ins that the scene names.
tracer::WorldSettings world_settings(const Options& options, const scene::Scene& scene);

/// What was asked for with "always" and cannot be in this world, each with the reason and what to do.
std::vector<std::string> ignored_options(const Options& options, const tracer::World& world);

}  // namespace orbs::tracer_cli
