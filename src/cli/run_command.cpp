#include "adapters/process/isolation.h"
#include "base/error.h"
#include "base/local_time.h"
#include "base/shell.h"
#include "base/terminal.h"
#include "cli/command_table.h"
#include "cli/interrupt.h"
#include "cli/options.h"
#include "cli/recorded_times.h"
#include "cli/run_options.h"
#include "cli/run_progress.h"
#include "cli/show_runs.h"
#include "report/files.h"
#include "report/table.h"
#include "run/accept_failures.h"
#include "run/cluster/shard.h"
#include "run/execute.h"
#include "run/plan/make_plan.h"
#include "run/plan/plan_text.h"
#include "run/run.h"
#include "run/run_file.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

namespace orbs::cli {

namespace {

// The plan of the shard that is to be rendered, and the list of the whole.
struct ShardPlan {
  run::Plan plan;
  registry::Shard shard{};
  results::JobList whole{};
};

// The run file of the folder that is resumed, or of a new folder, which is made.
run::RunFile run_file_of(const registry::Configuration& configuration,
                         const run::Plan& plan,
                         const registry::Shard& shard,
                         const std::string& resumed,
                         std::filesystem::path& folder) {
  if (!resumed.empty()) {
    folder = std::filesystem::absolute(resumed).lexically_normal();
    auto file = run::read_run_file(folder);
    file.settings = plan.settings;
    return file;
  }
  folder = run::make_run_folder(plan.settings.output);
  run::RunFile file{configuration.file, plan.settings, local_time_now(), shard};
  if (file.settings.executable.find('/') != std::string::npos)
    file.settings.executable = std::filesystem::absolute(file.settings.executable).lexically_normal();
  return file;
}

// Before anything starts: a configuration that was found above may not be the one that was meant.
void announce(const registry::Configuration& configuration,
              const run::Plan& plan,
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
results::RunRecord render_with_progress(const run::Plan& plan,
                                        const std::filesystem::path& folder,
                                        const std::map<std::string, double>& seconds,
                                        run::RunContext& context) {
  std::vector<std::string> ids;
  for (const auto& job : plan.jobs) ids.push_back(job.id);
  const auto run = [&] {
    RunProgress progress(seconds, ids, plan.settings.jobs);
    context.rendering.started = [&](const auto& job) { progress.started(job); };
    context.rendering.progress = [&](std::size_t done, std::size_t count, const auto& job,
                                     const auto& targets) { progress.finished(done, count, job, targets); };
    context.rendering.say = [&](const std::string& line) { progress.say(line); };
    auto made = run::run(plan, folder, context);
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
             const ShardPlan& planned,
             const Program& program,
             const RunOptions& options) {
  const auto& plan = planned.plan;
  std::filesystem::path folder;
  run::RunContext context;
  context.file = run_file_of(configuration, plan, planned.shard, options.resume, folder);
  context.whole_plan = planned.whole;
  const auto times = recorded_times(plan, std::filesystem::current_path(),
                                    options.resume.empty() ? std::filesystem::path() : folder);
  announce(configuration, plan, times, folder);
  context.rendering.orbs_version = program.version;
  context.command_line = program.command_line;
  context.rendering.stop = &catch_interrupts();
  auto record = render_with_progress(plan, folder, times.seconds, context);
  const bool accepts = !options.accept_failures.empty() && !record.interrupted;
  const auto accepted = accepts ? run::accept_failures(configuration, options.accept_failures, record) : 0;
  if (accepted > 0) report::write_reports(record, folder);
  print_end(record, folder);
  if (accepts)
    print_clean("{} known failure{} written to {}\n", accepted, accepted == 1 ? "" : "s",
                configuration.file.string());
  if (plan.settings.view && !record.interrupted) show_runs({folder}, program, {"127.0.0.1", 0, true});
  return record.interrupted ? kInterrupted : results::exit_status(record);
}

}  // namespace

void add_run_command(const command_line::Command& command, const Program& program, Action& action) {
  const auto configuration = add_configuration_option(command);
  const auto options = std::make_shared<RunOptions>();
  add_run_options(command, *options);
  command.footer(
      "configuration.json can set the default of every option under \"defaults\".\n"
      "Exit status: 0 if every target that a renderer declares passes or is a known failure, 1 if one fails, 2 if the run could not "
      "start\nor every target is unsupported, 130 if it was interrupted (--resume continues it).");
  command.callback([=, &program, &action] {
    action = [=, &program] {
      auto from = *configuration;
      std::optional<registry::RunSettings> resumed;
      ShardPlan planned;
      if (!options->shard.empty()) planned.shard = registry::parse_shard(options->shard);
      if (!options->resume.empty()) {
        const auto file = run::read_run_file(options->resume);
        if (from.empty()) from = file.configuration.string();
        resumed = file.settings;
        planned.shard = file.shard;
      }
      const auto read = read_configuration(from, program);
      const auto settings = run_settings(command, *options, resumed.value_or(read.defaults));
      planned.plan = run::make_plan(read, settings, program.folder);
      planned.whole = run::job_list(planned.plan);
      run::take_shard(planned.shard, planned.plan);
      if (settings.sandbox)
        if (const auto reason = adapters::why_not_isolated(); !reason.empty()) throw InputError(reason);
      if (!settings.dry_run) return run_plan(read, planned, program, *options);
      print_clean("{}", run::plan_text(planned.plan));
      return 0;
    };
  });
}

}  // namespace orbs::cli
