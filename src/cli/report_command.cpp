#include "base/error.h"
#include "base/files.h"
#include "base/terminal.h"
#include "base/text_table.h"
#include "cli/program.h"
#include "cli/show_runs.h"
#include "report/page_file.h"
#include "results/study_kinds.h"

#include <optional>

#include <fmt/format.h>
#include <unistd.h>

namespace orbs::cli {

namespace {

struct ReportOptions {
  std::string run;
  std::string output;
  std::optional<double> most_megabytes;
  bool exact = false;
};

// A report is one file, whereas runs and studies are folders: whoever names a folder is told a file in it.
void check_report_file(const std::string& output) {
  std::error_code ignored;
  if (std::filesystem::is_directory(output, ignored))
    throw InputError(fmt::format("-o {}: this is a folder, and a report is one file: -o {}", output,
                                 (std::filesystem::path(output) / "report.html").string()));
  check_output_file(output);
}

// Hundreds of lines would push what was written out of sight.
void print_left_out(const std::vector<std::string>& files) {
  constexpr std::size_t kMost = 5;
  if (files.empty()) return;
  const int width = terminal_width(STDOUT_FILENO);
  const auto print = [&](const std::string& line) { print_clean("{}", wrapped_lines(line, width)); };
  print(fmt::format("{} images are not in it ('orbs serve' shows them; --most-megabytes makes room):\n",
                    files.size()));
  const auto shown = files.size() <= kMost + 1 ? files.size() : kMost;
  for (std::size_t i = 0; i < shown; ++i) print(fmt::format("- {}\n", files[i]));
  if (shown < files.size()) print(fmt::format("- and {} more\n", files.size() - shown));
}

int write_report(const ReportOptions& options, const Program& program) {
  constexpr double kMegabyte = 1e6;
  constexpr double kRunMegabytes = 100;
  constexpr double kStudyMegabytes = 5;  // small enough for a mail
  check_report_file(options.output);
  report::PageFileSettings settings;
  settings.bundle = program.folder / "web";
  settings.exact = options.exact;
  const auto folder =
      options.run.empty() ? newest_runs_and_studies().front() : std::filesystem::path(options.run);
  const bool is_study = results::study_kind_in(folder) != nullptr;
  settings.most_bytes = static_cast<std::size_t>(
      options.most_megabytes.value_or(is_study ? kStudyMegabytes : kRunMegabytes) * kMegabyte);
  const auto page = is_study ? report::study_page_file(folder, settings)
                             : report::page_file(results::read_run_folder(folder), settings);
  write_file(options.output, page.text);
  print_clean("{}: {:.1f} MB, {} images\n", options.output, static_cast<double>(page.text.size()) / kMegabyte,
              page.images);
  print_left_out(page.left_out);
  return 0;
}

}  // namespace

void add_report_command(const command_line::Command& command, const Program& program, Action& action) {
  constexpr double kMostMegabytes = 1e6;
  const auto options = std::make_shared<ReportOptions>();
  command
      .add_option(
          "run", options->run,
          "Folder of the run or study (default: the newest outputs-*, cost-* or stability-* in the working folder)")
      .not_empty("a folder");
  command.add_option("-o,--output", options->output, "The file to write").required().not_empty("a file");
  command
      .add_option("--most-megabytes", options->most_megabytes,
                  "Room for images; those of failures come first (default: 100, of a study 5)")
      .zero_or_more()
      .range(0.0, kMostMegabytes);
  command.add_flag("--exact", options->exact, "Store images with all digits instead of as 16-bit floats");
  command.callback(
      [=, &program, &action] { action = [=, &program] { return write_report(*options, program); }; });
}

}  // namespace orbs::cli
