#include "adapters/process/isolation.h"
#include "base/error.h"
#include "base/local_time.h"
#include "base/shell.h"
#include "base/terminal.h"
#include "cli/checks.h"
#include "cli/command_table.h"
#include "cli/interrupt.h"
#include "cli/options.h"
#include "cli/recorded_times.h"
#include "cli/run_progress.h"
#include "cli/show_runs.h"
#include "registry/image_size.h"
#include "report/files.h"
#include "report/table.h"
#include "runner/execute.h"
#include "runner/make_plan.h"
#include "runner/plan_text.h"
#include "runner/run.h"
#include "runner/run_file.h"

#include <algorithm>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

namespace orbs::cli {

namespace {

// The options of the command line; the configuration sets those that are not given.
struct RunOptions {
  std::string suite;
  std::vector<std::string> cases, scenes, requirements, renderers;
  std::string executable;
  std::string output;
  std::string resume;
  int jobs = 1;
  int threads = 0;
  int seed = 1;
  double spp_scale = 1;
  std::string size;
  bool log = true;
  bool sandbox = false;
  bool dry_run = false;
  bool view = false;
};

void add_options(CLI::App& command, RunOptions& options) {
  constexpr int kMost = 1024;
  command.add_option("--suite", options.suite, "The suite (default: that of the configuration)");
  command.add_option("-c,--case", options.cases,
                     "Only these cases: names or patterns like 'm*', separated by commas");
  command.add_option("-s,--scene", options.scenes, "Only these scenes");
  command.add_option("--requirement", options.requirements, "Only these requirements, for example 'M*,L3'");
  command.add_option("-r,--renderer", options.renderers,
                     "Only these renderers (default: all that are installed)");
  command.add_option("-e,--exec", options.executable,
                     "Program to start instead of the chosen renderer's own");
  command
      .add_option("-o,--output", options.output,
                  "New folder for the results (default: outputs-YYMMDD-HHMMSS)")
      ->check(not_empty("a folder"));
  auto* resume = command
                     .add_option("--resume", options.resume,
                                 "Continue the run in this folder, with its own suite, cases and renderers")
                     ->check(not_empty("a folder"));
  command.add_option("-j,--jobs", options.jobs, "Number of renders at the same time (default: 1)")
      ->check(CLI::Range(1, kMost));
  command
      .add_option("--threads", options.threads,
                  "Threads of one render (default: 0, the cores divided by --jobs)")
      ->check(CLI::Range(0, kMost));
  command.add_option("--seed", options.seed, "Seed of all renders (default: 1)")
      ->check(zero_or_more())
      ->check(CLI::Range(0, registry::kLargestSeed));
  command.add_option("--spp-scale", options.spp_scale, "Factor of all samples per pixel (default: 1)")
      ->check(above_zero());
  add_size_option(command, options.size);
  command.add_flag("-l,--log,!--no-log", options.log,
                   "Keep log.txt of every render; --no-log keeps only those of failures");
  command.add_flag("-v,--view,--visualize,!--no-view", options.view,
                   "At the end, serve the results as a page and open it in the browser");
  command.add_flag(
      "--sandbox,!--no-sandbox", options.sandbox,
      "Run renderers under bubblewrap: no network, no references, only their own folder writable");
  command.add_flag("--dry-run,!--no-dry-run", options.dry_run,
                   "Print the renders and their commands, and start nothing");
  for (const char* choice :
       {"--suite", "--case", "--scene", "--requirement", "--renderer", "--output", "--size"})
    resume->excludes(command.get_option(choice)->option_text("NAMES"));
  for (const char* number : {"--jobs", "--threads", "--seed", "--spp-scale"})
    command.get_option(number)->option_text("NUMBER");
  command.get_option("--exec")->option_text("PROGRAM");
  command.get_option("--size")->option_text("SHARE");
  command.get_option("--suite")->option_text("NAME");
  command.get_option("--output")->option_text("FOLDER");
  resume->option_text("FOLDER");
}

template <typename T>
void take(const CLI::App& command, const char* option, const T& given, T& setting) {
  if (command.count(option) > 0) setting = given;
}

void take_list(const CLI::App& command,
               const char* option,
               const std::vector<std::string>& given,
               std::string& setting) {
  if (command.count(option) > 0) setting = joined_list(given);
}

registry::RunSettings settings_of(const CLI::App& command,
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
  if (command.count("--exec") > 0 && settings.executable.empty())
    throw InputError("-e/--exec needs a program");
  return settings;
}

// The run file of the folder that is resumed, or of a new folder, which is made.
runner::RunFile run_file_of(const registry::Configuration& configuration,
                            const runner::Plan& plan,
                            const std::string& resumed,
                            std::filesystem::path& folder) {
  if (!resumed.empty()) {
    folder = std::filesystem::absolute(resumed).lexically_normal();
    auto file = runner::read_run_file(folder);
    file.settings = plan.settings;
    return file;
  }
  folder = runner::make_run_folder(plan.settings.output);
  runner::RunFile file{configuration.file, plan.settings, local_time_now()};
  if (file.settings.executable.find('/') != std::string::npos)
    file.settings.executable = std::filesystem::absolute(file.settings.executable).lexically_normal();
  return file;
}

// Before anything starts: a configuration that was found above may not be the one that was meant.
void announce(const registry::Configuration& configuration,
              const runner::Plan& plan,
              const RecordedTimes& times,
              const std::filesystem::path& folder) {
  std::vector<std::string> names;
  for (const auto& renderer : plan.renderers) names.push_back(renderer.entry.name);
  const bool is_here = configuration.file.parent_path() == std::filesystem::current_path();
  print_clean(stderr, "configuration: {}{}\n", configuration.file.string(),
              is_here ? "" : ", which is not in this folder");
  print_clean(stderr, "suite {} with {}: {}\n", plan.suite.name, fmt::join(names, ", "),
              amount_text(plan, times));
  for (const auto& left : plan.left_out)
    print_clean(stderr, "left out: {}: {}\n", left.renderer, left.reason);
  print_clean(stderr, "results: {}\n", folder.string());
}

void print_end(const results::RunRecord& record, const std::filesystem::path& folder) {
  print_clean("\n{}\n{:.1f} s in all; results: {}\n",
              report::summary_text(record, report::style_for(STDOUT_FILENO)), record.wall_seconds,
              folder.string());
  if (results::judged_nothing(record))
    print_clean(stderr, "orbs: nothing was judged: every target is unsupported, for the reasons above\n");
  const auto relative = folder.lexically_proximate(std::filesystem::current_path()).string();
  const std::vector<std::string> argv = record.interrupted
                                            ? std::vector<std::string>{"orbs", "run", "--resume", relative}
                                            : std::vector<std::string>{"orbs", "serve", relative};
  print_clean("next: {}   ({})\n", shell_text(argv),
              record.interrupted ? "continues this run" : "shows the images in the browser");
}

// InputError with a note where the run was; says how it can be continued if there is anything to continue.
results::RunRecord render_with_progress(const runner::Plan& plan,
                                        const std::filesystem::path& folder,
                                        const std::map<std::string, double>& seconds,
                                        runner::RunContext& context) {
  std::vector<std::string> ids;
  for (const auto& job : plan.jobs) ids.push_back(job.id);
  const auto run = [&] {
    RunProgress progress(seconds, ids, plan.settings.jobs);
    context.rendering.started = [&](const auto& job) { progress.started(job); };
    context.rendering.progress = [&](std::size_t done, std::size_t count, const auto& job,
                                     const auto& targets) { progress.finished(done, count, job, targets); };
    context.rendering.say = [&](const std::string& line) { progress.say(line); };
    auto made = runner::run(plan, folder, context);
    report::write_reports(made, folder);
    return made;
  };
  try {
    return with_note(fmt::format("running in {}", folder.string()), run);
  } catch (const InputError&) {
    std::error_code ignored;
    if (std::filesystem::exists(folder / "run.json", ignored))
      print_clean(stderr, "{} continues the run\n", shell_text({"orbs", "run", "--resume", folder.string()}));
    throw;
  }
}

int run_plan(const registry::Configuration& configuration,
             const runner::Plan& plan,
             const Program& program,
             const RunOptions& options) {
  std::filesystem::path folder;
  runner::RunContext context;
  context.file = run_file_of(configuration, plan, options.resume, folder);
  const auto times = recorded_times(plan, std::filesystem::current_path(),
                                    options.resume.empty() ? std::filesystem::path() : folder);
  announce(configuration, plan, times, folder);
  context.rendering.orbs_version = program.version;
  context.command_line = program.command_line;
  context.rendering.stop = &catch_interrupts();
  const auto record = render_with_progress(plan, folder, times.seconds, context);
  print_end(record, folder);
  if (plan.settings.view && !record.interrupted) show_runs({folder}, program, {"127.0.0.1", 0, true});
  return record.interrupted ? kInterrupted : results::exit_status(record);
}

}  // namespace

void add_run_command(CLI::App& command, const Program& program, Action& action) {
  const auto configuration = add_configuration_option(command);
  const auto options = std::make_shared<RunOptions>();
  add_options(command, *options);
  command.footer(
      "configuration.json can set the default of every option under \"defaults\".\n"
      "Exit status: 0 if every target that a renderer declares passes, 1 if one fails, 2 if the run could not "
      "start\nor every target is unsupported, 130 if it was interrupted (--resume continues it).");
  const auto* chosen = &command;
  command.callback([=, &program, &action] {
    action = [=, &program] {
      auto from = *configuration;
      std::optional<registry::RunSettings> resumed;
      if (!options->resume.empty()) {
        const auto file = runner::read_run_file(options->resume);
        if (from.empty()) from = file.configuration.string();
        resumed = file.settings;
      }
      const auto read = read_configuration(from, program);
      const auto settings = settings_of(*chosen, *options, resumed.value_or(read.defaults));
      const auto plan = runner::make_plan(read, settings, program.folder);
      if (settings.sandbox)
        if (const auto reason = adapters::why_not_isolated(); !reason.empty()) throw InputError(reason);
      if (!settings.dry_run) return run_plan(read, plan, program, *options);
      print_clean("{}", runner::plan_text(plan));
      return 0;
    };
  });
}

}  // namespace orbs::cli
