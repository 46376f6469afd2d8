#include "base/error.h"
#include "base/files.h"
#include "base/terminal.h"
#include "base/text.h"
#include "cli/options.h"
#include "cli/program.h"
#include "cli/run/recorded_times.h"
#include "cli/run/run_options.h"
#include "run/cluster/slurm.h"
#include "run/cluster/slurm_calls.h"
#include "run/plan/make_plan.h"
#include "run/plan/plan_file.h"
#include "run/run_file.h"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

namespace orbs::cli {

namespace {

namespace fs = std::filesystem;

struct Options {
  RunOptions run;
  bool slurm = false;
  int shards = 0;
  std::string resume;
  bool dry_run = false;
};

// The arrays that a merge waits for: what waits of an earlier one belongs into the whole, too.
std::vector<std::string> awaited(const run::Queued& queued, const std::string& array) {
  auto arrays = queued.arrays;
  arrays.push_back(array);
  return arrays;
}

int print_calls(const run::SlurmJob& job, const std::vector<int>& shards, const run::Queued& queued) {
  print_clean("{}\n{}\n", shell_text(run::array_words(job, shards)),
              shell_text(run::merge_words(job, awaited(queued, "ID"))));
  return 0;
}

// The id of the array is written down before anything else happens: who resumes this folder asks for it.
int submit_shards(run::SlurmJob& job, const std::vector<int>& shards, const run::Queued& queued) {
  if (!queued.tasks.empty())
    print_clean("shards {} wait in Slurm's queue or render now, and are not submitted again\n",
                run::array_text(queued.tasks));
  if (shards.empty()) {
    if (queued.tasks.empty())
      print_clean("all {} shards are complete; orbs merge puts them together\n", job.shards);
    return 0;
  }
  const auto array = run::submit(run::array_words(job, shards));
  job.arrays.push_back(array);
  run::write_slurm_job(job);
  const auto merge = run::submit(run::merge_words(job, awaited(queued, array)));
  print_clean("submitted: array {} of {} shards, then merge {}\nresults: {}\n", array, shards.size(), merge,
              (job.folder / "merged").string());
  return 0;
}

std::vector<int> all_shards(const run::SlurmJob& job) {
  std::vector<int> shards;
  for (int shard = 1; shard <= job.shards; ++shard) shards.push_back(shard);
  return shards;
}

int submit_plan(const registry::Configuration& configuration,
                const registry::RunSettings& settings,
                const Program& program,
                const Options& options) {
  const auto plan = run::make_plan(configuration, settings, program.folder);
  const auto measured = recorded_times(plan, {fs::current_path()}, {}).peak_rss_bytes;
  auto job = run::slurm_job(configuration.slurm, plan, measured,
                            fs::absolute(options.run.output.empty() ? "FOLDER" : options.run.output),
                            options.shards);
  if (options.dry_run) return print_calls(job, all_shards(job), {});
  job.folder = run::make_run_folder(options.run.output, "cluster");
  run::write_plan(run::filed_plan(plan, program.version), job.folder);
  run::write_slurm_job(job);
  const auto submitted = [&] { return submit_shards(job, all_shards(job), {}); };
  return with_note(fmt::format("submitting {}; once the reason is mended, {} submits it", job.folder.string(),
                               shell_text({called_as(program.command_line), "submit", "--slurm", "--resume",
                                           job.folder.string()})),
                   submitted);
}

// With the settings of Slurm as they are now in the configuration, and the memory as it is known now:
// whatever it was that Slurm refused, or ended.
int submit_again(const std::string& configuration, const Options& options, const Program& program) {
  const auto before = run::read_slurm_job(options.resume);
  auto filed = run::read_plan(before.folder / run::kPlanFile);
  take_configuration(configuration, program, filed);
  const auto read = read_configuration(resolve_path(filed.root, filed.configuration).string(), program);
  const auto plan = run::load_plan(filed, program.folder, program.version).plan;
  std::vector<fs::path> rendered;
  for (const int shard : all_shards(before)) rendered.push_back(run::shard_folder(before, shard));
  const auto measured = recorded_times(plan, {fs::current_path()}, rendered).peak_rss_bytes;
  auto job = run::slurm_job(read.slurm, plan, measured, before.folder, before.shards);
  job.arrays = before.arrays;
  const auto queued = run::ask_queue(job.arrays);
  auto shards = run::missing_shards(job);
  std::erase_if(
      shards, [&](int shard) { return std::binary_search(queued.tasks.begin(), queued.tasks.end(), shard); });
  if (options.dry_run && !shards.empty()) return print_calls(job, shards, queued);
  // Tasks that wait read the scripts when they start: nothing in these depends on the settings.
  run::write_slurm_job(job);
  return submit_shards(job, shards, queued);
}

}  // namespace

void add_submit_command(const command_line::Command& command, const Program& program, Action& action) {
  const auto configuration = add_configuration_option(command);
  const auto options = std::make_shared<Options>();
  command.add_flag("--slurm", options->slurm, "Submit to Slurm, the one engine that there is").required();
  add_choice_options(command, options->run);
  command
      .add_option("-o,--output", options->run.output,
                  "New folder for shards and results, which all nodes see (default: cluster-YYMMDD-HHMMSS)")
      .value_name("FOLDER")
      .not_empty("a folder");
  command
      .add_option("--shards", options->shards, "Number of tasks (default: one for each render, at most 1000)")
      .value_name("NUMBER")
      .range(1, 100'000);
  const auto resume =
      command
          .add_option("--resume", options->resume,
                      "Submit the shards of this folder that are neither complete nor in Slurm's queue")
          .value_name("FOLDER")
          .not_empty("a folder");
  command.add_flag("--dry-run", options->dry_run, "Print the calls of sbatch, and do nothing");
  for (const auto* name :
       {"--suite", "--case", "--scene", "--requirement", "--renderer", "--output", "--shards"})
    resume.excludes(command.option(name));
  command.callback([=, &program, &action] {
    action = [=, &program] {
      if (!options->resume.empty()) return submit_again(*configuration, *options, program);
      const auto read = read_configuration(*configuration, program);
      return submit_plan(read, run_settings(command, options->run, read.defaults), program, *options);
    };
  });
}

}  // namespace orbs::cli
