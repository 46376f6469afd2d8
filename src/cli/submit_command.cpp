#include "base/terminal.h"
#include "base/text.h"
#include "cli/options.h"
#include "cli/program.h"
#include "cli/run_options.h"
#include "run/cluster/slurm.h"
#include "run/plan/make_plan.h"
#include "run/plan/plan_file.h"
#include "run/run_file.h"

#include <fmt/format.h>

namespace orbs::cli {

namespace {

struct Options {
  RunOptions run;
  bool slurm = false;
  int shards = 0;
  std::string resume;
  bool dry_run = false;
};

int submit_missing(const run::SlurmJob& job, const std::vector<int>& shards) {
  if (shards.empty()) {
    print_clean("all {} shards are complete; orbs merge puts them together\n", job.shards);
    return 0;
  }
  const auto array = run::submit(run::array_words(job, shards));
  const auto merge = run::submit(run::merge_words(job, array));
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
  auto job = run::slurm_job(
      configuration.slurm, plan,
      std::filesystem::absolute(options.run.output.empty() ? "FOLDER" : options.run.output), options.shards);
  if (options.dry_run) {
    print_clean("{}\n{}\n", shell_text(run::array_words(job, all_shards(job))),
                shell_text(run::merge_words(job, "ID")));
    return 0;
  }
  job.folder = run::make_run_folder(options.run.output, "cluster");
  run::write_plan(run::filed_plan(plan, program.version), job.folder);
  run::write_slurm_job(job);
  return submit_missing(job, all_shards(job));
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
  const auto resume = command
                          .add_option("--resume", options->resume,
                                      "Submit the shards again that are not complete in this folder")
                          .value_name("FOLDER")
                          .not_empty("a folder");
  command.add_flag("--dry-run", options->dry_run, "Print the calls of sbatch, and do nothing");
  for (const auto* name :
       {"--suite", "--case", "--scene", "--requirement", "--renderer", "--output", "--shards"})
    resume.excludes(command.option(name));
  command.callback([=, &program, &action] {
    action = [=, &program] {
      if (!options->resume.empty()) {
        const auto job = run::read_slurm_job(options->resume);
        return submit_missing(job, run::missing_shards(job));
      }
      const auto read = read_configuration(*configuration, program);
      return submit_plan(read, run_settings(command, options->run, read.defaults), program, *options);
    };
  });
}

}  // namespace orbs::cli
