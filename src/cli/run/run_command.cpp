#include "base/error.h"
#include "base/files.h"
#include "base/local_time.h"
#include "base/terminal.h"
#include "base/text.h"
#include "cli/interrupt.h"
#include "cli/options.h"
#include "cli/program.h"
#include "cli/run/last_failed.h"
#include "cli/run/recorded_times.h"
#include "cli/run/run_end.h"
#include "cli/run/run_options.h"
#include "cli/run/run_progress.h"
#include "cli/show_runs.h"
#include "report/files.h"
#include "run/cluster/shard.h"
#include "run/expected.h"
#include "run/plan/make_plan.h"
#include "run/plan/plan.h"
#include "run/plan/plan_file.h"
#include "run/plan/plan_text.h"
#include "run/run.h"
#include "run/run_file.h"

#include <algorithm>
#include <set>
#include <string>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

namespace orbs::cli {

namespace {

// What is to be done: the plan of the shard that is rendered, and the file of the whole plan.
struct Planned {
  run::Plan plan{};
  run::FiledPlan whole{};
  run::RunFile file{};
  std::string nothing_to_do{};  // why nothing is rendered; "" if something is
};

// Before anything starts: a configuration that was found above may not be the one that was meant.
void announce(const run::Plan& plan, const RecordedTimes& times, const std::filesystem::path& folder) {
  std::vector<std::string> names;
  for (const auto& renderer : plan.renderers) names.push_back(renderer.entry.name);
  const bool is_here = plan.configuration.parent_path() == std::filesystem::current_path();
  print_clean(stderr, "configuration: {}{}\n", plan.configuration.string(),
              is_here ? "" : ", which is not in this folder");
  for (const auto& file : plan.below) print_clean(stderr, "  over {}\n", file.string());
  print_clean(stderr, "suite {} with {}: {}\n", plan.suite.name, fmt::join(names, ", "),
              amount_text(plan, times));
  for (const auto& left : plan.left_out)
    print_clean(stderr, "left out: {}: {}\n", left.renderer, left.reason);
  std::set<std::string> warnings;  // several targets may have one scene
  for (const auto& scene : plan.scenes)
    warnings.insert(scene.scene->notes.warnings.begin(), scene.scene->notes.warnings.end());
  for (const auto& warning : warnings) print_clean(stderr, "warning: {}\n", warning);
  print_clean(stderr, "results: {}\n", folder.string());
}

// InputError with a note where the run was; says how it can be continued if there is anything to continue.
results::RunRecord render_with_progress(const run::Plan& plan,
                                        const std::filesystem::path& folder,
                                        const RecordedTimes& times,
                                        run::RunContext& context) {
  const auto run = [&] {
    RunProgress progress(plan, times);
    int failed = 0;
    context.rendering.started = [&](const auto& job) { progress.started(job); };
    context.rendering.progress = [&](std::size_t done, std::size_t count, const auto& job,
                                     const auto& targets) {
      progress.finished(done, count, job, targets);
      failed += static_cast<int>(std::count_if(targets.begin(), targets.end(), fails_run));
      if (plan.settings.max_fail > 0 && failed >= plan.settings.max_fail) wind_up();
    };
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
      print_clean(stderr, "{} continues the run\n",
                  shell_text({called_as(context.command_line), "run", "--resume", folder.string()}));
    throw;
  }
}

results::RunRecord run_plan(const Planned& planned, const Program& program, const RunOptions& options) {
  const auto& plan = planned.plan;
  const bool is_resumed = !options.resume.empty();
  const auto folder = is_resumed ? std::filesystem::absolute(options.resume).lexically_normal()
                                 : run::make_run_folder(plan.settings.output);
  run::RunContext context;
  context.file = planned.file;
  context.whole_plan = planned.whole;
  const auto times = recorded_times(plan, {std::filesystem::current_path(), folder.parent_path()},
                                    is_resumed ? std::vector{folder} : std::vector<std::filesystem::path>{});
  if (!plan.settings.quiet) announce(plan, times, folder);
  context.rendering.orbs_version = program.version;
  context.command_line = program.command_line;
  context.rendering.stop = &catch_interrupts();
  auto record = render_with_progress(plan, folder, times, context);
  const bool accepts = !options.accept_failures.empty() && !record.interrupted;
  const auto configuration =
      accepts ? read_configuration(plan.configuration.string(), program) : registry::Configuration{};
  const auto accepted = accepts ? run::accept_failures(configuration, options.accept_failures, record) : 0;
  if (accepted > 0) report::write_reports(record, folder);
  // Of runs that are repeated there is one summary, of all.
  if (plan.settings.repeat == 1) print_end(record, plan.settings, folder, program);
  if (accepts)
    print_clean("{} known failure{} written to {}\n", accepted, accepted == 1 ? "" : "s",
                configuration.own_file.string());
  if (plan.settings.view && !record.interrupted) show_runs({folder}, program, {"127.0.0.1", 0, true});
  return record;
}

// A run that ended early because enough had failed has failed.
int status_of(const results::RunRecord& record, const registry::RunSettings& settings) {
  return record.interrupted && !ended_by_failures(record, settings) ? kInterrupted
                                                                    : results::exit_status(record);
}

// The plan of a file as it stands. Only what changes no image may be chosen anew.
Planned planned_by_file(const command_line::Command& command,
                        run::FiledPlan filed,
                        const std::string& configuration,
                        const RunOptions& options,
                        const Program& program) {
  if (!filed.rendered_here)
    throw InputError(
        "this is the plan of scenes that orbs export wrote for a renderer that is elsewhere; orbs judge judges "
        "its images");
  for (const char* choice : {"--exec", "--threads", "--seed", "--spp-scale"})
    if (command.is_given(choice))
      throw InputError(
          fmt::format("{} is part of the plan, which is executed as it is; make another plan", choice));
  take_configuration(configuration, program, filed);
  auto loaded = run::load_plan(filed, program.folder, program.version);
  using run::PlanPart;
  run::refuse_changes(loaded, {PlanPart::Version, PlanPart::Program, PlanPart::Case, PlanPart::Scene});
  auto settings = loaded.plan.settings;
  settings.view = settings.dry_run = false;  // whoever made the plan wanted to see it, and not this part
  loaded.plan.settings = run_settings(command, options, settings);
  return {std::move(loaded.plan), std::move(filed)};
}

Planned planned_anew(const registry::Configuration& configuration,
                     const registry::RunSettings& settings,
                     const std::vector<run::OnlyTarget>& only,
                     const Program& program) {
  auto plan = run::make_plan(configuration, settings, program.folder);
  if (!only.empty()) run::take_targets(only, plan);
  auto whole = settings.dry_run ? run::FiledPlan{} : run::filed_plan(plan, program.version);
  return {std::move(plan), std::move(whole)};
}

// A whole run is planned again when it is resumed, so that it takes up what has changed; a shard stays with
// the plan of the others.
Planned planned_as(const command_line::Command& command,
                   const std::string& configuration,
                   const RunOptions& options,
                   const Program& program) {
  Planned planned;
  run::RunFile file{local_time_now(), {}};
  if (!options.shard.empty()) file.shard = registry::parse_shard(options.shard);
  if (!options.plan.empty()) {
    planned = planned_by_file(command, run::read_plan(options.plan), configuration, options, program);
    file.label = planned.plan.settings.label;
  } else if (options.resume.empty()) {
    const auto read = read_configuration(configuration, program);
    const auto settings = run_settings(command, options, read.defaults);
    file.label = settings.label;
    if (settings.last_failed) {
      const auto last = last_failed(settings);
      if (last.targets.empty())
        return {.nothing_to_do = fmt::format("nothing failed in {}", last.run.string())};
      file.only = last.targets;
    }
    planned = planned_anew(read, settings, file.only, program);
    if (settings.last_failed && planned.plan.targets.empty())
      return {.nothing_to_do = "what failed last is not among what is chosen"};
  } else {
    file = run::read_run_file(options.resume);
    auto filed = run::read_plan(std::filesystem::path(options.resume) / run::kPlanFile);
    if (file.shard.count > 1) {
      planned = planned_by_file(command, std::move(filed), configuration, options, program);
    } else {
      const auto from = resolve_path(filed.root, filed.configuration);
      const auto read = read_configuration(configuration.empty() ? from.string() : configuration, program);
      if (filed.settings.executable.find('/') != std::string::npos)
        filed.settings.executable = resolve_path(filed.root, filed.settings.executable).string();
      planned = planned_anew(read, run_settings(command, options, filed.settings), file.only, program);
    }
  }
  planned.file = file;
  run::take_shard(file.shard, planned.plan);
  return planned;
}

int say_nothing_to_do(const Planned& planned) {
  print_clean("nothing to render: {}\n", planned.nothing_to_do);
  return 0;
}

// Runs with other seeds, in folders of one. A render may take as many seeds as it has replicas, so that the
// seeds of two runs lie that far apart.
int run_repeatedly(const Planned& first,
                   const registry::Configuration& configuration,
                   const Program& program,
                   const RunOptions& options) {
  const auto& settings = first.plan.settings;
  const int stride = registry::kMostSeeds;
  if (settings.seed > registry::kLargestSeed - stride * (settings.repeat - 1))
    throw InputError(fmt::format("--repeat {} needs seeds up to {}; choose a smaller --seed", settings.repeat,
                                 registry::kLargestSeed));
  const auto folder = run::make_run_folder(settings.output);
  std::vector<results::RunRecord> runs;
  int status = 0;
  for (int i = 0; i < settings.repeat && !catch_interrupts().load(); ++i) {
    auto one = settings;
    one.seed = settings.seed + stride * i;
    one.output = (folder / fmt::format("seed-{}", one.seed)).string();
    auto planned = planned_anew(configuration, one, first.file.only, program);
    planned.file = first.file;
    runs.push_back(run_plan(planned, program, options));
    status = std::max(status, status_of(runs.back(), one));
  }
  print_clean("\n{}results: {}\n", repeats_text(runs, terminal_width(STDOUT_FILENO)), folder.string());
  return status;
}

int run_as_wanted(const command_line::Command& command,
                  const std::string& configuration,
                  const RunOptions& options,
                  const Program& program) {
  const auto planned = planned_as(command, configuration, options, program);
  if (!planned.nothing_to_do.empty()) return say_nothing_to_do(planned);
  const auto& settings = planned.plan.settings;
  refuse_without_sandbox(settings.sandbox);
  if (settings.repeat > 1)
    return run_repeatedly(planned, read_configuration(configuration, program), program, options);
  if (!settings.dry_run) return status_of(run_plan(planned, program, options), settings);
  const auto times = recorded_times(planned.plan, {std::filesystem::current_path()}, {});
  print_clean("{}{}\n", run::plan_text(planned.plan), amount_text(planned.plan, times));
  return 0;
}

}  // namespace

void add_run_command(const command_line::Command& command, const Program& program, Action& action) {
  const auto configuration = add_configuration_option(command);
  const auto options = std::make_shared<RunOptions>();
  add_run_options(command, *options);
  command.footer(
      "configuration.json can set the default of every option under \"defaults\".\n"
      "Exit status: 0 if every target that a renderer declares passes or is a known failure, 1 if one fails, 2 if the run could not "
      "start or every target is unsupported, 130 if it was interrupted (--resume continues it).");
  command.callback([=, &program, &action] {
    action = [=, &program] { return run_as_wanted(command, *configuration, *options, program); };
  });
}

}  // namespace orbs::cli
