#pragma once

#include "registry/configuration.h"

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace CLI {  // NOLINT(readability-identifier-naming): the name is the library's
class App;
}

/// The commands of the program orbs: each reads its options and calls what does the work. Exit status 0: all
/// as expected, 1: something failed, 2: could not run.
namespace orbs::cli {

struct Program {
  std::string version;
  std::filesystem::path folder;  // where orbs itself lies: {build}
  std::vector<std::string> command_line;
};

/// What the chosen command does, called after all options are read.
using Action = std::function<int()>;

void add_run_command(CLI::App& app, const Program& program, Action& action);
void add_list_command(CLI::App& app, const Program& program, Action& action);
void add_doctor_command(CLI::App& app, const Program& program, Action& action);
void add_compare_command(CLI::App& app, const Program& program, Action& action);
void add_renderer_command(CLI::App& app, const Program& program, Action& action);
void add_reference_command(CLI::App& app, const Program& program, Action& action);
void add_plan_command(CLI::App& app, const Program& program, Action& action);
void add_effect_cost_command(CLI::App& app, const Program& program, Action& action);
void add_probe_command(CLI::App& app, const Program& program, Action& action);
void add_qualify_command(CLI::App& app, const Program& program, Action& action);
void add_bench_command(CLI::App& app, const Program& program, Action& action);
void add_serve_command(CLI::App& app, const Program& program, Action& action);
void add_report_command(CLI::App& app, const Program& program, Action& action);

/// Folders outputs-* of the working folder that hold a run, the newest first. InputError when there is none.
std::vector<std::filesystem::path> newest_runs();

struct ShowSettings {
  std::string address = "127.0.0.1";
  int port = 0;
  bool open = false;  // in the browser
};

/// Serves runs until the user interrupts.
void show_runs(const std::vector<std::filesystem::path>& runs,
               const Program& program,
               const ShowSettings& settings);

/// --configuration FILE; the text that it fills.
std::shared_ptr<std::string> add_configuration_option(CLI::App& command);

/// The file that is named, or the nearest configuration.json above the working folder or, failing that, above
/// the program.
registry::Configuration read_configuration(const std::string& named, const Program& program);

/// The values of a repeatable option as one comma-separated list.
std::string joined_list(const std::vector<std::string>& values);

/// Runs the program; never throws.
int run_program(int argc, char** argv, const std::string& version);

}  // namespace orbs::cli
