#include "cli/run_options.h"

#include "base/error.h"
#include "cli/checks.h"
#include "cli/options.h"
#include "registry/image_size.h"

#include <CLI/CLI.hpp>

namespace orbs::cli {

void add_choice_options(CLI::App& command, RunOptions& options) {
  constexpr int kMost = 1024;
  command.add_option("--suite", options.suite, "The suite (default: that of the configuration)")
      ->option_text("NAME");
  command.add_option("-c,--case", options.cases,
                     "Only these cases: names or patterns like 'm*', separated by commas");
  command.add_option("-s,--scene", options.scenes, "Only these scenes");
  command.add_option("--requirement", options.requirements, "Only these requirements, for example 'M*,L3'");
  command.add_option("-r,--renderer", options.renderers,
                     "Only these renderers (default: all that are installed)");
  command
      .add_option("-e,--exec", options.executable, "Program to start instead of the chosen renderer's own")
      ->option_text("PROGRAM");
  command.add_option("-j,--jobs", options.jobs, "Number of renders at the same time (default: 1)")
      ->check(CLI::Range(1, kMost));
  command
      .add_option("--threads", options.threads,
                  "Threads of one render (default: 0, the cores divided by --jobs)")
      ->check(CLI::Range(0, kMost));
  command.add_option("--seed", options.seed, "Seed of all renders (default: 1)")
      ->check(zero_or_more())
      ->check(CLI::Range(0, registry::kLargestSeed));
  command
      .add_option("--spp-scale", options.spp_scale,
                  "Multiply every scene's samples per pixel by this (default: 1)")
      ->check(above_zero());
  add_size_option(command, options.size);
  command.add_flag("-l,--log,!--no-log", options.log,
                   "Keep log.txt of every render; --no-log keeps only those of failures");
  command.add_flag(
      "--sandbox,!--no-sandbox", options.sandbox,
      "Run renderers under bubblewrap: no network, no references, only their own folder writable");
  for (const char* names : {"--case", "--scene", "--requirement", "--renderer"})
    command.get_option(names)->option_text("NAMES");
  for (const char* number : {"--jobs", "--threads", "--seed", "--spp-scale"})
    command.get_option(number)->option_text("NUMBER");
  command.get_option("--size")->option_text("SHARE");
}

void add_run_options(CLI::App& command, RunOptions& options) {
  add_choice_options(command, options);
  command
      .add_option("-o,--output", options.output,
                  "New folder for the results (default: outputs-YYMMDD-HHMMSS)")
      ->option_text("FOLDER")
      ->check(not_empty("a folder"));
  auto* resume = command
                     .add_option("--resume", options.resume,
                                 "Continue the run in this folder, with its own suite, cases and renderers")
                     ->option_text("FOLDER")
                     ->check(not_empty("a folder"));
  command
      .add_option("--shard", options.shard,
                  "Only this part of the renders, such as 3/16; 'orbs merge' puts all parts together")
      ->option_text("PART")
      ->check(not_empty("a part"));
  auto* plan = command
                   .add_option("--plan", options.plan,
                               "Execute the plan in this file: plan.json of a run or of orbs submit")
                   ->option_text("FILE")
                   ->check(not_empty("a file"));
  command.add_flag("-v,--view,--visualize,!--no-view", options.view,
                   "At the end, serve the results as a page and open it in the browser");
  command.add_flag("--dry-run,!--no-dry-run", options.dry_run,
                   "Print the renders and their commands, and start nothing");
  command
      .add_option("--accept-failures", options.accept_failures,
                  "Write what fails in this run into the configuration as known failures, with this reason")
      ->option_text("REASON")
      ->excludes("--dry-run")
      ->check(not_empty("a reason"));
  for (const char* choice : {"--suite", "--case", "--scene", "--requirement", "--renderer", "--size"}) {
    resume->excludes(command.get_option(choice));
    plan->excludes(command.get_option(choice));
  }
  for (const char* choice : {"--output", "--shard", "--plan"}) resume->excludes(command.get_option(choice));
}

namespace {

template <typename T>
void take(const CLI::App& command, const char* option, const T& given, T& setting) {
  const auto* found = command.get_option_no_throw(option);
  if (found != nullptr && found->count() > 0) setting = given;
}

void take_list(const CLI::App& command,
               const char* option,
               const std::vector<std::string>& given,
               std::string& setting) {
  take(command, option, joined_list(given), setting);
}

}  // namespace

registry::RunSettings run_settings(const CLI::App& command,
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
  if (command.count("--size") > 0) settings.size_divisor = registry::size_divisor(options.size);
  take(command, "--log", options.log, settings.log);
  take(command, "--sandbox", options.sandbox, settings.sandbox);
  take(command, "--dry-run", options.dry_run, settings.dry_run);
  take(command, "--view", options.view, settings.view);
  const auto* executable = command.get_option_no_throw("--exec");
  if (executable != nullptr && executable->count() > 0 && settings.executable.empty())
    throw InputError("-e/--exec needs a program");
  return settings;
}

}  // namespace orbs::cli
