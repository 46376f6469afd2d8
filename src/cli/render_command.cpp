#include "base/error.h"
#include "base/files.h"
#include "base/local_time.h"
#include "base/terminal.h"
#include "base/text.h"
#include "cli/options.h"
#include "cli/program.h"
#include "cli/run/run_options.h"
#include "run/plan/make_plan.h"
#include "run/plan/plan_file.h"
#include "run/run.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace orbs::cli {

namespace {

struct RenderOptions {
  RunOptions run;
  std::string output = "render.exr";
  int spp = 0;  // 0: those of the case
};

void add_options(const command_line::Command& command, RenderOptions& options) {
  add_settings(command, options.run,
               {"suite", "case", "scene", "renderer", "exec", "seed", "threads", "size", "sandbox"});
  command.add_option("--spp", options.spp, "Samples per pixel (default: those of the case)")
      .range(1, 1 << 20);
  command.add_option("-o,--output", options.output, "File for the image, *.exr")
      .value_name("FILE")
      .shows_default()
      .not_empty("a file");
}

// The first of many are enough to see what was chosen.
std::string names_text(std::vector<std::string> names) {
  constexpr std::size_t kMost = 4;
  const bool is_cut = names.size() > kMost;
  if (is_cut) names.resize(kMost);
  return fmt::format("{}{}", fmt::join(names, ", "), is_cut ? ", ..." : "");
}

// What was chosen must be one image. A scene that several cases judge is one.
void refuse_other_than_one(const run::Plan& plan) {
  std::vector<std::string> scenes;
  for (const auto& scene : plan.scenes) scenes.push_back(scene.name);
  if (scenes.size() != 1)
    throw InputError(fmt::format("one image is of one scene, and {} are chosen ({}); name one with -s",
                                 scenes.size(), names_text(scenes)));
  if (plan.renderers.size() != 1) {
    std::vector<std::string> names;
    for (const auto& renderer : plan.renderers) names.push_back(renderer.entry.name);
    throw InputError(fmt::format("one image is of one renderer, and {} are chosen ({}); name one with -r",
                                 names.size(), names_text(names)));
  }
  if (!plan.jobs.empty()) return;
  for (const auto& target : plan.targets)
    if (!target.unsupported.empty())
      throw InputError(fmt::format("{} cannot render {}: {}", plan.renderers[0].entry.name, target.target,
                                   target.unsupported));
  throw InputError(fmt::format("{} does not declare what {} needs; 'orbs doctor -r {}' says what it declares",
                               plan.renderers[0].entry.name, plan.scenes[0].name,
                               plan.renderers[0].entry.name));
}

// A run of one render that nothing judges: no second way to start a renderer.
run::Plan plan_of_one(const command_line::Command& command,
                      const registry::Configuration& configuration,
                      const RenderOptions& options,
                      const Program& program) {
  auto settings = study_settings(command, options.run, configuration.defaults);
  settings.fixed_samples = true;
  settings.jobs = 1;
  auto plan = run::make_plan(configuration, settings, program.folder);
  refuse_other_than_one(plan);
  plan.targets.clear();
  plan.cases.clear();
  plan.expected.clear();
  plan.jobs.front().has_condition = false;
  if (options.spp > 0) plan.jobs.front().spp = options.spp;
  return plan;
}

int render(const command_line::Command& command,
           const registry::Configuration& configuration,
           const RenderOptions& options,
           const Program& program) {
  if (!options.output.ends_with(".exr"))
    throw InputError(
        fmt::format("--output: images are written as OpenEXR; expected a name that ends with .exr, "
                    "not '{}'",
                    options.output));
  check_output_file(options.output);
  const auto plan = plan_of_one(command, configuration, options, program);
  const ScratchFolder scratch("orbs-render");
  const auto folder = run::make_run_folder((scratch.path() / "run").string());
  const auto studied = study_context(program, stderr);
  run::RunContext context;
  context.file.started = local_time_now();
  context.whole_plan = run::filed_plan(plan, program.version);
  context.command_line = program.command_line;
  context.rendering.orbs_version = program.version;
  context.rendering.stop = studied.stop;
  context.rendering.say = studied.say;
  const auto made = run::run(plan, folder, context);
  if (made.interrupted) return kInterrupted;
  const auto& job = made.jobs.front();
  if (!has_image(job)) {
    print_clean(stderr, "orbs: {} made no image of {}: {}\n", job.identity.renderer, job.identity.scene,
                job.end.reason);
    return 1;
  }
  write_file(options.output, read_file(folder / job.files.image));
  const auto& camera = plan.scenes.front().scene->camera;
  print_clean("{}: {} x {} pixels of {} by {}, {} samples per pixel, {:.1f} s ({:.1f} s of CPU)\n",
              options.output, camera.width_px, camera.height_px, job.identity.scene, job.identity.renderer,
              job.identity.spp, job.cost.wall_seconds, job.cost.cpu_seconds);
  return 0;
}

}  // namespace

void add_render_command(const command_line::Command& command, const Program& program, Action& action) {
  const auto configuration = add_configuration_option(command);
  const auto options = std::make_shared<RenderOptions>();
  add_options(command, *options);
  command.footer(
      "Renders one scene with one renderer as a run does, and judges nothing.\n"
      "Exit status: 0 if the image was written, 1 if the renderer made none, 2 for bad input.");
  command.callback([=, &program, &action] {
    action = [=, &program] {
      return render(command, read_configuration(*configuration, program), *options, program);
    };
  });
}

}  // namespace orbs::cli
