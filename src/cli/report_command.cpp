#include "base/error.h"
#include "base/files.h"
#include "cli/commands.h"
#include "cli/not_empty.h"
#include "cli/number_checks.h"
#include "report/page_file.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace orbs::cli {

namespace {

struct ReportOptions {
  std::string run;
  std::string output;
  double most_megabytes = 100;
  bool exact = false;
};

int write_report(const ReportOptions& options, const Program& program) {
  constexpr double kMegabyte = 1e6;
  report::PageFileSettings settings;
  settings.bundle = program.folder / "web";
  settings.most_bytes = static_cast<std::size_t>(options.most_megabytes * kMegabyte);
  settings.exact = options.exact;
  const auto folder = options.run.empty() ? newest_runs().front() : std::filesystem::path(options.run);
  const auto view = results::read_run_folder(folder);
  const auto page = report::page_file(view, settings);
  write_file(options.output, page.text);
  fmt::print("{}: {:.1f} MB, {} images\n", options.output, static_cast<double>(page.text.size()) / kMegabyte,
             page.images);
  if (!page.left_out.empty())
    fmt::print("{} images are not in it ('orbs serve' shows them; --most-megabytes makes room):\n",
               page.left_out.size());
  for (const auto& file : page.left_out) fmt::print("  {}\n", file);
  return 0;
}

}  // namespace

void add_report_command(CLI::App& app, const Program& program, Action& action) {
  auto* command = app.add_subcommand("report", "Writes the page of a run as one HTML file");
  const auto options = std::make_shared<ReportOptions>();
  command->add_option("run", options->run, "folder of the run (default: the newest outputs-* here)");
  command->add_option("-o,--output", options->output, "the file to write")
      ->required()
      ->check(not_empty("a file"));
  command
      ->add_option("--most-megabytes", options->most_megabytes, "room for images; failures are taken first")
      ->check(zero_or_more());
  command->add_flag("--exact", options->exact, "images with all their digits instead of 16-bit floats");
  command->callback(
      [=, &program, &action] { action = [=, &program] { return write_report(*options, program); }; });
}

}  // namespace orbs::cli
