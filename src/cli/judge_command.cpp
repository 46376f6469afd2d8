#include "base/files.h"
#include "base/local_time.h"
#include "base/terminal.h"
#include "base/text.h"
#include "cli/options.h"
#include "cli/program.h"
#include "report/files.h"
#include "report/table.h"
#include "run/plan/plan_file.h"
#include "run/run.h"

#include <unistd.h>

namespace orbs::cli {

namespace {

struct Options {
  std::string folder;
  std::string output;
};

// Where the plan was made, or, when its folder is on another machine, the nearest.
std::string configuration_of(const run::FiledPlan& filed, const std::string& named, const Program& program) {
  std::error_code ignored;
  const auto cases = resolve_path(filed.root, filed.suite.cases);
  if (!named.empty() || std::filesystem::is_directory(cases, ignored)) return named;
  return read_configuration("", program).file.string();
}

int judge(const Options& options, const std::string& configuration, const Program& program) {
  auto filed = run::read_plan(std::filesystem::path(options.folder) / run::kPlanFile);
  take_configuration(configuration_of(filed, configuration, program), program, filed);
  auto loaded = run::load_plan(filed, program.folder, program.version);
  // Images may be judged by gates of today, but must be of the scenes of today.
  run::refuse_changes(loaded, {run::PlanPart::Scene});
  auto& plan = loaded.plan;
  plan.images = std::filesystem::absolute(options.folder);
  const auto folder = run::make_run_folder(options.output);
  run::RunContext context;
  context.file = {local_time_now(), {}};
  context.whole_plan = filed;
  context.command_line = program.command_line;
  context.rendering.orbs_version = program.version;
  const auto record = run::run(plan, folder, context);
  report::write_reports(record, folder);
  print_clean("\n{}\nresults: {}\n", report::summary_text(record, report::style_for(STDOUT_FILENO)),
              folder.string());
  const auto relative = folder.lexically_proximate(std::filesystem::current_path()).string();
  print_clean("next: {}   (shows the images in the browser)\n",
              shell_text({called_as(program.command_line), "serve", relative}));
  return results::exit_status(record);
}

}  // namespace

void add_judge_command(const command_line::Command& command, const Program& program, Action& action) {
  const auto configuration = add_configuration_option(command);
  const auto options = std::make_shared<Options>();
  command
      .add_option("folder", options->folder,
                  "Folder that orbs export made, with the images that were rendered")
      .required()
      .not_empty("a folder");
  command
      .add_option("-o,--output", options->output,
                  "New folder for the results (default: outputs-YYMMDD-HHMMSS)")
      .value_name("FOLDER")
      .not_empty("a folder");
  command.footer("Exit status: as orbs run.");
  command.callback([=, &program, &action] {
    action = [=, &program] { return judge(*options, *configuration, program); };
  });
}

}  // namespace orbs::cli
