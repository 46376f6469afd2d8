#include "base/error.h"
#include "base/files.h"
#include "base/terminal.h"
#include "cli/options.h"
#include "cli/program.h"
#include "cli/run/resume_hint.h"
#include "cli/run/run_options.h"
#include "results/host_record.h"
#include "results/study_kinds.h"
#include "run/host.h"
#include "run/plan/make_plan.h"
#include "run/run_file.h"
#include "studies/cost/json.h"
#include "studies/cost/report.h"
#include "studies/cost/study.h"

#include <fmt/format.h>
#include <unistd.h>

namespace orbs::cli {

namespace {

struct CostOptions {
  RunOptions run;
  std::string output, resume, show;
  studies::CostRequest request;
  bool as_markdown = false;
};

void add_options(const command_line::Command& command, CostOptions& options) {
  constexpr int kMost = 1024;
  add_settings(command, options.run,
               {"suite", "case", "scene", "requirement", "renderer", "size", "sandbox"});
  command
      .add_option("--time", options.request.settings.budget_seconds,
                  "Budget of the whole study: 30s, 20m, 2h (default: 20m)")
      .in_units(command_line::kTimes)
      .value_name("TIME");
  command
      .add_option("--target", options.request.settings.target_db,
                  "PSNR that the curves are to cross (default: 35dB)")
      .in_units({{"dB", 1}, {"", 1}})
      .value_name("PSNR");
  command
      .add_option(
          "--sweep", options.request.samples,
          "Samples per pixel of each curve: 16,64,256 (default: chosen by a pilot render of each curve)")
      .separated_by(',')
      .range(1, 1 << 24);
  command.add_option("--seeds", options.request.settings.seeds, "Renders of each setting")
      .range(2, kMost)
      .shows_default();
  command.add_option("--order-seed", options.request.settings.order_seed, "Seed of the order of the renders")
      .range(0, 1 << 20)
      .shows_default();
  command.add_option("--threads", options.request.settings.threads, "Threads of each render; 0: all cores")
      .range(0, kMost);
  const auto output =
      command
          .add_option("-o,--output", options.output, "New folder of the study (default: cost-YYMMDD-HHMMSS)")
          .not_empty("a folder");
  const auto resume =
      command
          .add_option("--resume", options.resume, "Continue the study in this folder with the same options")
          .not_empty("a folder");
  const auto show =
      command
          .add_option("--show", options.show,
                      "Print the tables of a study (its folder or cost.json) and measure nothing")
          .not_empty("a folder or a file");
  resume.excludes(output);
  show.excludes(output).excludes(resume);
  command.add_flag("--markdown", options.as_markdown, "Print the tables as Markdown, for every error target");
}

std::filesystem::path cost_file(const std::string& place) {
  const std::filesystem::path path(place);
  std::error_code ignored;
  return std::filesystem::is_directory(path, ignored) ? path / results::kCost.file : path;
}

void report(const studies::CostRecord& record, const CostOptions& options) {
  print_clean("{}", options.as_markdown ? studies::cost_markdown(record)
                                        : studies::cost_table(record, terminal_style(STDOUT_FILENO)));
}

// What an interrupted study had measured. Times of another machine are no part of the same study.
studies::CostRecord earlier_record(const std::string& folder) {
  auto record = studies::read_cost_file(cost_file(folder));
  const auto there = results::timing_machine(record.host);
  const auto here = results::timing_machine(run::this_host());
  if (there != here)
    throw InputError(
        fmt::format("{} was measured on another machine ({}), so its times and those of this one ({}) "
                    "cannot be compared; begin a new study",
                    folder, there, here));
  return record;
}

int measure(const command_line::Command& command,
            const registry::Configuration& configuration,
            CostOptions options,
            const Program& program) {
  auto settings = study_settings(command, options.run, configuration.defaults);
  settings.threads = options.request.settings.threads;
  settings.jobs = 1;
  auto& request = options.request;
  const auto plan = run::make_plan(configuration, settings, program.folder);
  const auto context = study_context(program, stderr);
  studies::CostRecord record;
  if (options.resume.empty()) {
    request.folder = run::make_run_folder(options.output, "cost");
  } else {
    request.folder = options.resume;
    record = earlier_record(options.resume);
  }
  record = studies::measure_cost(plan, request, std::move(record), context);
  write_file(request.folder / "cost.csv", studies::cost_csv(record));
  report(record, options);
  print_clean("all numbers: {}\n{}", (request.folder / results::kCost.file).string(),
              next_line(program.command_line, request.folder.string(), record.is_finished,
                        "shows the curves in the browser"));
  return record.is_finished ? 0 : kInterrupted;
}

}  // namespace

void add_cost_command(const command_line::Command& command, const Program& program, Action& action) {
  const auto configuration = add_configuration_option(command);
  const auto options = std::make_shared<CostOptions>();
  add_options(command, *options);
  command.footer(
      "Renders each scene with more and more samples and shows error against time: how long each renderer takes "
      "to a given error, what one more decibel costs, and whether a bias remains. Run it on an idle machine.");
  command.callback([=, &program, &action] {
    action = [=, &program] {
      if (!options->show.empty()) {
        report(studies::read_cost_file(cost_file(options->show)), *options);
        return 0;
      }
      return measure(command, read_configuration(*configuration, program), *options, program);
    };
  });
}

}  // namespace orbs::cli
