#include "base/error.h"
#include "base/files.h"
#include "base/terminal.h"
#include "base/text_table.h"
#include "cli/options.h"
#include "cli/program.h"
#include "cli/run/resume_hint.h"
#include "cli/run/run_options.h"
#include "results/study_kinds.h"
#include "run/plan/make_plan.h"
#include "run/run_file.h"
#include "scene/load/load_scene.h"
#include "studies/stability/json.h"
#include "studies/stability/report.h"
#include "studies/stability/study.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

namespace orbs::cli {

namespace {

struct StabilityOptions {
  RunOptions run;
  std::vector<std::string> files, relations, show;
  std::string output, resume;
  studies::StabilitySettings settings;
  bool as_markdown = false;
};

void add_study_options(const command_line::Command& command, StabilityOptions& options) {
  constexpr int kMostThreads = 1024;
  command.add_option("files", options.files, "Scene files to render instead of scenes of the suite");
  add_settings(command, options.run, {"suite", "case", "scene", "requirement", "renderer", "sandbox"});
  command.add_option("--relation", options.relations, "Relations, by name or pattern (default: all)")
      .separated_by(',');
  command.add_option("--side", options.settings.size_px, "Longer side of the images in pixels")
      .range(8, 1024)
      .shows_default();
  refuse_size_in_pixels(command);
  command.add_option("--spp", options.settings.spp, "Samples per pixel").range(2, 1 << 16).shows_default();
  command.add_option("--seeds", options.settings.seeds, "Pairs of images of each step")
      .range(2, 1024)
      .shows_default();
  command.add_option("--threads", options.settings.threads, "Threads of each render")
      .range(1, kMostThreads)
      .shows_default();
}

void add_folder_options(const command_line::Command& command, StabilityOptions& options) {
  const auto output = command
                          .add_option("-o,--output", options.output,
                                      "New folder of the study (default: stability-YYMMDD-HHMMSS)")
                          .not_empty("a folder");
  const auto resume =
      command
          .add_option("--resume", options.resume, "Continue the study in this folder with the same options")
          .not_empty("a folder");
  const auto show =
      command
          .add_option(
              "--show", options.show,
              "Print the tables of a study (its folder or stability.json) and render nothing; of "
              "several with the same scenes and settings but samples, one table of all their renderers")
          .not_empty("a folder or a file");
  resume.excludes(output);
  show.excludes(output).excludes(resume);
  command.add_flag("--markdown", options.as_markdown, "Print the tables as Markdown");
}

std::filesystem::path stability_file(const std::string& place) {
  const std::filesystem::path path(place);
  std::error_code ignored;
  return std::filesystem::is_directory(path, ignored) ? path / results::kStability.file : path;
}

void print(const studies::StabilityRecord& record, bool as_markdown) {
  print_clean("{}", as_markdown ? studies::stability_markdown(record)
                                : studies::stability_table(record, terminal_style(STDOUT_FILENO)));
}

int status_of(const studies::StabilityRecord& record) { return studies::all_hold(record) ? 0 : 1; }

// Their images lie beside the files, so that the tables can show them.
studies::StabilityRecord shown(const std::vector<std::string>& places) {
  std::vector<studies::StabilityRecord> records;
  for (const auto& place : places) {
    const auto file = stability_file(place);
    records.push_back(studies::read_stability_file(file));
    for (auto& step : records.back().steps)
      if (!step.images.empty()) step.images = (file.parent_path() / step.images).string();
  }
  return studies::joined(records);
}

// The scenes of these files, known by their names without folder and ending.
std::vector<run::PlannedScene> scenes_of(const std::vector<std::string>& files) {
  std::vector<run::PlannedScene> scenes;
  for (const std::filesystem::path file : files) {
    auto scene =
        with_note(fmt::format("reading scene '{}'", file.string()), [&] { return scene::load_scene(file); });
    run::PlannedScene planned;
    planned.name = file.stem().string();
    planned.file = std::filesystem::absolute(file);
    planned.scene = std::make_shared<const scene::Scene>(std::move(scene));
    scenes.push_back(std::move(planned));
  }
  return scenes;
}

int measure(const command_line::Command& command,
            const registry::Configuration& configuration,
            const StabilityOptions& options,
            const Program& program) {
  studies::StabilityRequest request{options.settings, studies::stability_relations(options.relations), {}};
  auto settings = study_settings(command, options.run, configuration.defaults);
  settings.size_divisor = registry::FullSize;  // a study of stability has its own size
  auto plan = run::make_plan(configuration, settings, program.folder);
  if (!options.files.empty()) plan.scenes = scenes_of(options.files);
  const auto context = study_context(program, stderr);
  studies::StabilityRecord record;
  if (options.resume.empty()) {
    request.folder = run::make_run_folder(options.output, "stability");
  } else {
    request.folder = std::filesystem::absolute(options.resume);
    record = studies::read_stability_file(stability_file(options.resume));
  }
  record = studies::measure_stability(plan, request, std::move(record), context);
  print(record, options.as_markdown);
  print_clean("all numbers: {}\n{}", (request.folder / results::kStability.file).string(),
              next_line(program.command_line, request.folder.string(), record.is_finished,
                        "shows the breaks in the browser"));
  return record.is_finished ? status_of(record) : kInterrupted;
}

std::string footer() {
  std::vector<std::string_view> names;
  for (const auto& relation : studies::stability_relations({})) names.push_back(relation.of_scenes.name);
  return fmt::format(
      "Renders each scene and changed forms of it, such as the same world 10 km away, whose images are known to "
      "be equal, and says how far each renderer follows. It needs no reference.\n"
      "Exit status: 0 all relations hold, 1 one breaks or nothing was measured.\nRelations: {}.",
      fmt::join(names, ", "));
}

}  // namespace

void add_stability_command(const command_line::Command& command, const Program& program, Action& action) {
  const auto configuration = add_configuration_option(command);
  const auto options = std::make_shared<StabilityOptions>();
  add_study_options(command, *options);
  add_folder_options(command, *options);
  command.footer(footer());
  command.callback([=, &program, &action] {
    action = [=, &program] {
      if (options->show.empty())
        return measure(command, read_configuration(*configuration, program), *options, program);
      const auto record = shown(options->show);
      print(record, options->as_markdown);
      return status_of(record);
    };
  });
}

}  // namespace orbs::cli
