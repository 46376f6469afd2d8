#include "base/error.h"
#include "base/files.h"
#include "cli/options.h"
#include "cli/program.h"
#include "cli/run/run_options.h"
#include "run/plan/make_plan.h"
#include "run/run_file.h"
#include "studies/probe/probe.h"
#include "studies/probe/report.h"

#include <algorithm>

#include <fmt/format.h>

namespace orbs::cli {

namespace {

struct ProbeOptions {
  RunOptions run;
  std::string output, keep;
  studies::ProbeSettings probe;
};

void add_options(const command_line::Command& command, ProbeOptions& options) {
  constexpr int kMostThreads = 1024;
  add_settings(command, options.run, {"suite", "case", "scene", "renderer", "exec", "sandbox"});
  command.add_option("--side", options.probe.most_px, "Longer side of the images in pixels")
      .range(16, 1024)
      .shows_default();
  refuse_size_in_pixels(command);
  command.add_option("--spp", options.probe.spp, "Samples per pixel").range(1, 4096).shows_default();
  command.add_option("--threads", options.probe.threads, "Threads of each render")
      .range(1, kMostThreads)
      .shows_default();
  command.add_option("-o,--output", options.output, "JSON file for all findings").not_empty("a file");
  command.add_option("--keep", options.keep, "New folder for the scenes and images of all passes")
      .value_name("FOLDER")
      .not_empty("a folder");
}

std::ptrdiff_t count(const std::vector<studies::ProbeRecord>& records, studies::ProbeVerdict verdict) {
  return std::count_if(records.begin(), records.end(),
                       [&](const auto& record) { return studies::probe_verdict(record) == verdict; });
}

std::string summary(const std::vector<studies::ProbeRecord>& records) {
  const auto right = count(records, studies::ProbeVerdict::Right);
  const auto wrong = count(records, studies::ProbeVerdict::Wrong);
  const auto unchecked = count(records, studies::ProbeVerdict::NotChecked);
  if (unchecked == 0 && wrong == 0) return fmt::format("all {} are right", right);
  return fmt::format("{} of {} are right{}{}", right, records.size(),
                     wrong == 0 ? "" : fmt::format(", {} not right", wrong),
                     unchecked == 0 ? "" : fmt::format(", {} not checked", unchecked));
}

int probe(const command_line::Command& command,
          const registry::Configuration& configuration,
          const ProbeOptions& options,
          const Program& program) {
  if (!options.output.empty()) check_output_file(options.output);
  auto settings = study_settings(command, options.run, configuration.defaults);
  settings.size_divisor = registry::FullSize;  // a probe has its own size
  const auto plan = run::make_plan(configuration, settings, program.folder);
  const auto context = study_context(program, stdout);
  auto probed = options.probe;
  if (!options.keep.empty()) probed.keep = run::make_run_folder(options.keep);
  const auto records = studies::run_probe(plan, probed, context);
  if (!options.output.empty()) write_file(options.output, studies::probe_json(records));
  if (is_stopped(context)) return kInterrupted;
  context.say(summary(records));
  return count(records, studies::ProbeVerdict::Wrong) == 0 && count(records, studies::ProbeVerdict::Right) > 0
             ? 0
             : 1;
}

}  // namespace

void add_probe_command(const command_line::Command& command, const Program& program, Action& action) {
  const auto configuration = add_configuration_option(command);
  const auto options = std::make_shared<ProbeOptions>();
  add_options(command, *options);
  command.footer(
      "Renders an id pass, in which every material of every instance and every light has a different colour, "
      "and a uv pass. A renderer that declares V1 also renders depth, position, normal and uv as layers (AOVs), as far as it "
      "has them. All are compared with primary visibility as orbs computes it from the scene.\n"
      "Exit status: 0 if all that could be checked is right, 1 if a renderer is not right or nothing could be "
      "checked.");
  command.callback([=, &program, &action] {
    action = [=, &program] {
      return probe(command, read_configuration(*configuration, program), *options, program);
    };
  });
}

}  // namespace orbs::cli
