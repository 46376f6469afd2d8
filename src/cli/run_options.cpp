#include "cli/run_options.h"

#include "base/error.h"
#include "cli/options.h"
#include "registry/image_size.h"

namespace orbs::cli {

void add_choice_options(const command_line::Command& command, RunOptions& options) {
  constexpr int kMost = 1024;
  command.add_option("--suite", options.suite, "The suite (default: that of the configuration)")
      .value_name("NAME");
  command.add_option("-c,--case", options.cases,
                     "Only these cases: names or patterns like 'm*', separated by commas");
  command.add_option("-s,--scene", options.scenes, "Only these scenes");
  command.add_option("--requirement", options.requirements, "Only these requirements, for example 'M*,L3'");
  command.add_option("-r,--renderer", options.renderers,
                     "Only these renderers (default: all that are installed)");
  command.add_option("-e,--exec", options.executable, "Program to start instead of the chosen renderer's own")
      .value_name("PROGRAM");
  command.add_option("-j,--jobs", options.jobs, "Number of renders at the same time (default: 1)")
      .range(1, kMost);
  command
      .add_option("--threads", options.threads,
                  "Threads of one render (default: 0, the cores divided by --jobs)")
      .range(0, kMost);
  command.add_option("--seed", options.seed, "Seed of all renders (default: 1)")
      .zero_or_more()
      .range(0, registry::kLargestSeed);
  command.add_option("--spp-scale", options.spp_scale, "Factor of all samples per pixel (default: 1)")
      .above_zero();
  add_size_option(command, options.size);
  command.add_flag("-l,--log,!--no-log", options.log,
                   "Keep log.txt of every render; --no-log keeps only those of failures");
  command.add_flag(
      "--sandbox,!--no-sandbox", options.sandbox,
      "Run renderers under bubblewrap: no network, no references, only their own folder writable");
  for (const char* names : {"--case", "--scene", "--requirement", "--renderer"})
    command.option(names).value_name("NAMES");
  for (const char* number : {"--jobs", "--threads", "--seed", "--spp-scale"})
    command.option(number).value_name("NUMBER");
  command.option("--size").value_name("SHARE");
}

void add_run_options(const command_line::Command& command, RunOptions& options) {
  add_choice_options(command, options);
  command
      .add_option("-o,--output", options.output,
                  "New folder for the results (default: outputs-YYMMDD-HHMMSS)")
      .value_name("FOLDER")
      .not_empty("a folder");
  const auto resume =
      command
          .add_option("--resume", options.resume,
                      "Continue the run in this folder, with its own suite, cases and renderers")
          .value_name("FOLDER")
          .not_empty("a folder");
  command
      .add_option("--shard", options.shard,
                  "Only this part of the renders, such as 3/16; 'orbs merge' puts all parts together")
      .value_name("PART")
      .not_empty("a part");
  command.add_flag("-v,--view,--visualize,!--no-view", options.view,
                   "At the end, serve the results as a page and open it in the browser");
  command.add_flag("--dry-run,!--no-dry-run", options.dry_run,
                   "Print the renders and their commands, and start nothing");
  command
      .add_option("--accept-failures", options.accept_failures,
                  "Write what fails in this run into the configuration as known failures, with this reason")
      .value_name("REASON")
      .excludes(command.option("--dry-run"))
      .not_empty("a reason");
  for (const char* choice :
       {"--suite", "--case", "--scene", "--requirement", "--renderer", "--output", "--size", "--shard"})
    resume.excludes(command.option(choice));
}

namespace {

template <typename T>
void take(const command_line::Command& command, const char* option, const T& given, T& setting) {
  if (command.is_given(option)) setting = given;
}

void take_list(const command_line::Command& command,
               const char* option,
               const std::vector<std::string>& given,
               std::string& setting) {
  take(command, option, joined_list(given), setting);
}

}  // namespace

registry::RunSettings run_settings(const command_line::Command& command,
                                   const RunOptions& options,
                                   registry::RunSettings settings) {
  take(command, "--suite", options.suite, settings.suite);
  take_list(command, "--case", options.cases, settings.cases);
  take_list(command, "--scene", options.scenes, settings.scenes);
  take_list(command, "--requirement", options.requirements, settings.requirements);
  take_list(command, "--renderer", options.renderers, settings.renderers);
  take(command, "--exec", options.executable, settings.executable);
  take(command, "--output", options.output, settings.output);
  take(command, "--jobs", options.jobs, settings.jobs);
  take(command, "--threads", options.threads, settings.threads);
  take(command, "--seed", options.seed, settings.seed);
  take(command, "--spp-scale", options.spp_scale, settings.spp_scale);
  if (command.is_given("--size")) settings.size_divisor = registry::size_divisor(options.size);
  take(command, "--log", options.log, settings.log);
  take(command, "--sandbox", options.sandbox, settings.sandbox);
  take(command, "--dry-run", options.dry_run, settings.dry_run);
  take(command, "--view", options.view, settings.view);
  if (command.is_given("--exec") && settings.executable.empty())
    throw InputError("-e/--exec needs a program");
  return settings;
}

}  // namespace orbs::cli
