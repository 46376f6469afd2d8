#include "run/cluster/export_plan.h"

#include "base/files.h"
#include "base/text.h"
#include "run/job_folder.h"
#include "run/prepare.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace orbs::run {

namespace {

namespace fs = std::filesystem;

// The words of the command as they are in the folder of the job, where the program is whatever RENDERER says.
std::string command_line(const adapters::Job& job, const ChosenRenderer& renderer) {
  std::vector<std::string> words;
  for (const auto& variable : renderer.entry.command.environment)
    if (variable.find('=') != std::string::npos) words.push_back(shell_text({variable}));
  // A quoted word is no assignment to the shell, but one to env.
  if (!words.empty()) words.insert(words.begin(), "env");
  for (const auto& word : job.argv) {
    const bool is_program = word == renderer.executable.string();
    words.push_back(is_program ? "\"$renderer\"" : shell_text({named_within(job.folder, word)}));
  }
  return fmt::format("{}", fmt::join(words, " "));
}

std::string job_lines(const Plan& plan, const PlannedJob& job, const std::vector<adapters::Job>& replicas) {
  const auto& renderer = plan.renderers[job.renderer];
  const auto& scene = plan.scenes[job.scene];
  const auto& camera = scene.scene->camera;
  std::vector<std::string> commands;
  for (const auto& replica : replicas) commands.push_back(command_line(replica, renderer));
  return fmt::format(
      "# {}: {} x {} px, trace depth {}, {} samples per pixel{}, seed {}\n"
      "renderer=${{RENDERER:-{}}}\n"
      "(cd {} && {})\n\n",
      scene.name, camera.width_px, camera.height_px, scene.scene->trace_depth, job.spp,
      replicas.size() > 1 ? fmt::format(" in {} images", replicas.size()) : "", plan.settings.seed,
      shell_text({renderer.executable.string()}), shell_text({job.folder.string()}),
      fmt::join(commands, " && "));
}

}  // namespace

ExportedPlan export_plan(const Plan& plan, const fs::path& folder) {
  ExportedPlan exported;
  std::string script =
      "#!/bin/sh\n"
      "# Renders all images that orbs judge wants. RENDERER=/path/to/program sh render.sh\n"
      "# An image is linear and has no tone curve: 32-bit float EXR, no denoiser, a box filter of one pixel.\n"
      "cd \"$(dirname \"$0\")\" || exit\n\n";
  for (const auto& job : plan.jobs) {
    const auto prepared = scene_for(plan, job);
    if (const auto* reason = std::get_if<std::string>(&prepared)) {
      exported.left_out.push_back(fmt::format("{} {}: {}", plan.renderers[job.renderer].entry.name,
                                              plan.scenes[job.scene].name, *reason));
      continue;
    }
    const auto replicas = replicas_of(plan, job, folder);
    make_folder(replicas.front().folder);
    write_job_scene(plan, job, std::get<scene::Scene>(prepared), replicas.front());
    script += job_lines(plan, job, replicas);
    ++exported.renders;
  }
  write_file(folder / "render.sh", script);
  return exported;
}

}  // namespace orbs::run
