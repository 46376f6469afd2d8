#include "base/bad_samples.h"
#include "base/error.h"
#include "base/terminal.h"
#include "image/image_io.h"
#include "scene/load/load_scene.h"
#include "scene/render_fault.h"
#include "tracer/choose_light.h"
#include "tracer/integrator/surface_layers.h"
#include "tracer/learn_light_guides.h"
#include "tracer/learn_light_selection.h"
#include "tracer/plugins/plugin_library.h"
#include "tracer/render.h"
#include "tracer/render/rendering.h"
#include "tracer/world/build_world.h"
#include "tracer_cli/faulty_program.h"
#include "tracer_cli/missing.h"
#include "tracer_cli/options.h"
#include "tracer_cli/stamp.h"

#include <atomic>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <unistd.h>

#ifndef ORBS_VERSION
#  define ORBS_VERSION "unknown"
#endif

namespace orbs::tracer_cli {

namespace {

// Shows the progress of a render: a bar on a terminal, or lines of JSON on standard output. show() is called
// after every tile and prints at most ten times a second.
class ProgressLine {
 public:
  explicit ProgressLine(bool as_json);

  void show(const tracer::Progress& progress);
  /// Clears the bar.
  void finish() const;

 private:
  bool as_json_;
  bool on_terminal_;
  double last_seconds_ = 0;
};

ProgressLine::ProgressLine(bool as_json) : as_json_(as_json), on_terminal_(::isatty(STDERR_FILENO) == 1) {}

void ProgressLine::show(const tracer::Progress& progress) {
  constexpr double kInterval = 0.1;  // seconds
  if (progress.seconds < last_seconds_ + kInterval) return;
  last_seconds_ = progress.seconds;
  if (as_json_) {
    print_clean("{{\"progress\": {:.4f}, \"spp\": {}, \"seconds\": {:.2f}}}\n", progress.done,
                progress.samples_per_pixel, progress.seconds);
    std::fflush(stdout);
  } else if (on_terminal_) {
    constexpr int kWidth = 40;
    const auto full = static_cast<std::size_t>(progress.done * kWidth);
    const double left = progress.seconds / progress.done - progress.seconds;
    print_raw(stderr,
              fmt::format("\r[{}{}] {:3.0f} %  {:.0f} s, {:.0f} s left ", std::string(full, '#'),
                          std::string(kWidth - full, '.'), 100 * progress.done, progress.seconds, left));
  }
}

void ProgressLine::finish() const {
  if (on_terminal_ && !as_json_ && last_seconds_ > 0) print_raw(stderr, fmt::format("\r{:79}\r", ""));
}

std::atomic<bool> stop{false};

extern "C" void request_stop(int) { stop = true; }

// True as long as plug-ins may run: only they call exit() then.
std::atomic<bool> is_rendering{false};

// At the end of the program, and so whenever exit() is called: its status would say that all is well.
extern "C" void refuse_exit() {
  if (!is_rendering) return;
  const auto file = tracer::plugin_being_opened();
  const auto who =
      file.empty() ? std::string("a plug-in") : fmt::format("the initialiser of plug-in {}", file);
  print_clean(stderr, "orbs-tracer: {} has called exit(), which would end the program as if all was well\n",
              who);
  std::fflush(nullptr);
  constexpr int kBadInput = 2;
  std::_Exit(kBadInput);
}

scene::Scene scene_for(const Options& options) {
  auto scene = scene::load_scene(options.scene, {}, options.camera);
  for (const auto& warning : scene.notes.warnings) print_clean(stderr, "orbs-tracer: warning: {}\n", warning);
  set_integrator(scene, options);
  if (options.width > 0) scene.camera.width_px = options.width;
  if (options.height > 0) scene.camera.height_px = options.height;
  const auto fault = scene::render_fault_named(options.fault);
  if (!fault) return scene;
  if (const auto why = scene::why_fault_changes_nothing(scene, *fault); !why.empty())
    print_clean(stderr, "orbs-tracer: warning: --fault {} changes nothing in scene '{}': {}\n", options.fault,
                scene.name, why);
  return scene::with_fault(std::move(scene), *fault);
}

// Keeps the algorithms that trial renderings show to be better; gives the time of the trials.
tracer::RenderTime choose_algorithms(const Options& options,
                                     const scene::Scene& scene,
                                     tracer::World& world) {
  auto time = tracer::choose_light(world, render_settings(options, scene),
                                   {.selection = options.light_selection == "auto",
                                    .paths = options.light_paths == "auto",
                                    .connections = options.light_connections == "auto"});
  if (options.light_selection == "learned")
    tracer::add(time, tracer::learn_light_selection(world.light_bvh, world, render_settings(options, scene)));
  if (options.light_connections == "always" && tracer::supports_light_connections(world)) {
    tracer::add(time, tracer::learn_light_guides(world, render_settings(options, scene)));
    world.connects_light_vertices = true;
  }
  // What the trial renderings met is no part of the image.
  tracer::reset_counts(world);
  return time;
}

void warn_of_ignored_options(const Options& options, const tracer::World& world) {
  for (const auto& ignored : ignored_options(options, world))
    print_clean(stderr, "orbs-tracer: warning: {}\n", ignored);
}

// The times of a rendering are those of all that it took.
void add_trials(tracer::Rendering& rendering, const tracer::RenderTime& trials) {
  rendering.seconds += trials.seconds;
  rendering.cpu_seconds += trials.cpu_seconds;
  rendering.traversal_seconds += trials.traversal_seconds;
}

void print_summary(const tracer::Rendering& r, const tracer::RenderTime& trials, bool as_json) {
  if (r.variance_leaves_floats)
    print_clean(stderr,
                "orbs-tracer: warning: the variances are beyond the range of floats, so the image has none; "
                "radiances between 1e-16 and 1e19 have them\n");
  if (r.bad_samples.count > 0)
    print_clean(stderr,
                "orbs-tracer: {} samples were not finite and are left out; the first one at pixel ({}, {})\n",
                r.bad_samples.count, r.bad_samples.first_x, r.bad_samples.first_y);
  if (as_json)
    print_clean(
        "{{\"progress\": 1, \"spp\": {}, \"render_seconds\": {:.4f}, \"cpu_seconds\": {:.4f}, "
        "\"traversal_seconds\": {:.4f}, \"trial_seconds\": {:.4f}, \"bad_samples\": {}}}\n",
        r.samples_per_pixel, r.seconds, r.cpu_seconds, r.traversal_seconds, trials.seconds,
        r.bad_samples.count);
  print_clean("orbs: render_seconds {:.4f}\n", r.seconds);
}

void warn_of_plugin_faults(const tracer::World& world) {
  if (const auto faults = tracer::plugin_faults(world.plugin_shapes); faults.count > 0)
    print_clean(stderr,
                "orbs-tracer: warning: plug-ins broke their rules {} times, which counted as misses: {}\n",
                faults.count, faults.what);
}

// Of a render that has all its samples.
int status_of(const tracer::Rendering& rendering, const Options& options, const tracer::World& world) {
  if (options.only_counts_bad_samples()) return 0;
  const auto missing = too_much_missing(rendering, world);
  if (missing.empty()) return 0;
  print_clean(stderr,
              "orbs-tracer: the image is written and lacks too much: {}; at most {} in a million may be "
              "(--bad-samples)\n",
              missing, kMostBadSamples_ppm);
  return kTooMuchMissing;
}

struct PluginsAllowed {
  PluginsAllowed() { is_rendering = true; }
  ~PluginsAllowed() { is_rendering = false; }
  PluginsAllowed(const PluginsAllowed&) = delete;
  PluginsAllowed& operator=(const PluginsAllowed&) = delete;
};

int run(const Options& options) {
  std::atexit(refuse_exit);
  std::at_quick_exit(refuse_exit);
  const PluginsAllowed guard;
  begin_numeric_fault(options.fault);
  const auto scene = as_kept(scene_for(options));
  auto world = tracer::make_world(scene, world_settings(options, scene));
  const auto trials = choose_algorithms(options, scene, world);
  warn_of_ignored_options(options, world);
  std::signal(SIGINT, request_stop);
  std::signal(SIGTERM, request_stop);
  ProgressLine line(options.as_json);
  auto rendering = tracer::render(world, render_settings(options, scene), stop,
                                  [&](const tracer::Progress& p) { line.show(p); });
  tracer::add_surface_layers(world, scene, render_settings(options, scene), rendering);
  line.finish();
  add_trials(rendering, trials);
  stamp(rendering, options, scene, world, ORBS_VERSION);
  image::write_exr(as_written(rendering.image), options.output);
  warn_of_plugin_faults(world);
  print_summary(rendering, trials, options.as_json);
  if (rendering.samples_per_pixel == options.render.samples_per_pixel)
    return status_of(rendering, options, world);
  print_clean(stderr, "orbs-tracer: stopped after {} of {} samples per pixel; {} holds what was finished\n",
              rendering.samples_per_pixel, options.render.samples_per_pixel, options.output);
  return kInterrupted;
}

}  // namespace

}  // namespace orbs::tracer_cli

int main(int argc, char** argv) {
  try {
    return orbs::tracer_cli::run(orbs::tracer_cli::parse_options(argc, argv, ORBS_VERSION));
  } catch (const orbs::InputError& e) {
    orbs::print_clean(stderr, "orbs-tracer: {}\n", e.what());
    return 2;
  } catch (const std::exception& e) {
    orbs::print_clean(stderr, "orbs-tracer: internal error: {}\n", e.what());
    return 3;
  }
}
