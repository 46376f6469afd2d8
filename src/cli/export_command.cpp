#include "adapters/export.h"
#include "base/error.h"
#include "base/terminal.h"
#include "cli/options.h"
#include "cli/program.h"
#include "cli/run/run_options.h"
#include "run/cluster/export_plan.h"
#include "run/plan/make_plan.h"
#include "run/plan/plan_file.h"
#include "run/run_file.h"

#include <algorithm>
#include <map>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace orbs::cli {

namespace {

struct Options {
  std::string format;
  RunOptions run;
};

// "orbs" is what a user calls the format that the configuration calls "orbs-scene".
std::map<std::string, std::string> named_formats() {
  std::map<std::string, std::string> formats;
  for (const auto& exporter : adapters::exporters()) {
    const std::string format = exporter.format;
    formats[format == registry::kNeutralFormat ? "orbs" : format] = format;
  }
  return formats;
}

// The first renderer that reads the format, unless one is named.
std::string renderer_of(const registry::Configuration& configuration, const std::string& format) {
  for (const auto& renderer : configuration.renderers)
    if (renderer.format.name == named_formats().at(format)) return renderer.name;
  throw InputError(fmt::format("{}: no renderer has the scene_format {}; 'orbs renderer add' makes an entry",
                               configuration.file.string(), named_formats().at(format)));
}

void check_format(const run::Plan& plan, const std::string& format) {
  for (const auto& renderer : plan.renderers)
    if (renderer.entry.format.name != named_formats().at(format))
      throw InputError(fmt::format("{} reads {}, not {}", registry::entry_name(renderer.entry),
                                   renderer.entry.format.name, named_formats().at(format)));
}

std::string next_step(const run::Plan& plan, const std::string& folder, const std::string& orbs) {
  const bool has_programs =
      std::none_of(plan.renderers.begin(), plan.renderers.end(),
                   [](const auto& renderer) { return renderer.entry.command.is_elsewhere; });
  return has_programs ? fmt::format("sh {}/render.sh, where the renderer is; then here: {} judge {}", folder,
                                    orbs, folder)
                      : fmt::format(
                            "render the images that {}/export.json lists and put each in its place there, or "
                            "RENDERER=... sh render.sh; then here: {} judge {}",
                            folder, orbs, folder);
}

int export_scenes(const command_line::Command& command,
                  const registry::Configuration& configuration,
                  registry::RunSettings settings,
                  const Options& options,
                  const Program& program) {
  const bool has_renderers = command.is_given("--renderer");
  if (options.format.empty() && !has_renderers)
    throw InputError(
        "expected a renderer (-r NAME) or a --format; 'orbs list renderers' shows what there is");
  if (!has_renderers) settings.renderers = renderer_of(configuration, options.format);
  const auto plan = run::make_plan(configuration, settings, program.folder, run::RenderPlace::Elsewhere);
  if (!options.format.empty()) check_format(plan, options.format);
  const auto folder = run::make_run_folder(options.run.output, "export");
  const auto exported = run::export_plan(plan, folder);
  run::write_plan(run::filed_plan(plan, program.version), folder);
  print_clean("{} renders written to {}\n", exported.renders, folder.string());
  for (const auto& left : exported.left_out) print_clean("left out: {}\n", left);
  print_clean("next: {}\n", next_step(plan, folder.string(), called_as(program.command_line)));
  return 0;
}

}  // namespace

void add_export_command(const command_line::Command& command, const Program& program, Action& action) {
  const auto configuration = add_configuration_option(command);
  const auto options = std::make_shared<Options>();
  std::vector<std::string> formats;
  for (const auto& [name, word] : named_formats()) formats.push_back(name);
  command.add_option("--format", options->format, "Scene format to write (default: what the renderers read)")
      .value_name("FORMAT")
      .one_of(formats);
  add_settings(command, options->run, settings_but([] {
                 auto left_out = registry::kCallSettings;
                 left_out.insert({"exec", "jobs", "log", "sandbox"});
                 return left_out;
               }()));
  command.add_option("-o,--output", options->run.output, "New folder (default: export-YYMMDD-HHMMSS)")
      .value_name("FOLDER")
      .not_empty("a folder");
  command.callback([=, &program, &action] {
    action = [=, &program] {
      const auto read = read_configuration(*configuration, program);
      return export_scenes(command, read, run_settings(command, options->run, read.defaults), *options,
                           program);
    };
  });
}

}  // namespace orbs::cli
