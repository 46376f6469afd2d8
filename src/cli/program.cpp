#include "adapters/export.h"
#include "base/error.h"
#include "base/text.h"
#include "cli/commands.h"
#include "cli/not_empty.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <exception>
#include <set>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace orbs::cli {

namespace {

constexpr int kBadInput = 2;
constexpr int kOurBug = 3;

std::filesystem::path own_folder() {
  std::error_code failed;
  const auto file = std::filesystem::read_symlink("/proc/self/exe", failed);
  return failed ? std::filesystem::current_path() : file.parent_path();
}

// CLI11 takes a word that is no command for a missing one.
void refuse_unknown_command(const CLI::App& app, int argc, char** argv) {
  if (argc < 2 || argv[1][0] == '-') return;
  std::set<std::string> names;
  for (const auto* command : app.get_subcommands({})) names.insert(command->get_name());
  if (!names.contains(argv[1]))
    throw InputError(fmt::format("there is no command '{}'{}; there are: {}", argv[1],
                                 closest(argv[1], names), fmt::join(names, ", ")));
}

int parse_and_act(int argc, char** argv, const std::string& version) {
  Program program{version, own_folder(), {argv, argv + argc}};
  CLI::App app{
      "Renders small test scenes with every renderer that is configured, and says which requirements "
      "each one meets."};
  app.name("orbs");
  app.set_version_flag("--version", "orbs " + version);
  app.require_subcommand(1);
  Action action;
  add_run_command(app, program, action);
  add_list_command(app, program, action);
  add_doctor_command(app, program, action);
  add_compare_command(app, program, action);
  add_renderer_command(app, program, action);
  add_reference_command(app, program, action);
  add_plan_command(app, program, action);
  add_effect_cost_command(app, program, action);
  add_probe_command(app, program, action);
  add_qualify_command(app, program, action);
  add_bench_command(app, program, action);
  add_serve_command(app, program, action);
  add_report_command(app, program, action);
  refuse_unknown_command(app, argc, argv);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    if (e.get_exit_code() == 0) return app.exit(e);
    const auto chosen = app.get_subcommands();
    const std::string command = chosen.empty() ? "" : chosen.front()->get_name() + " ";
    throw InputError(fmt::format("{}; 'orbs {}--help' shows what there is", e.what(), command));
  }
  return action();
}

// The exporters know the words of "scene_format", the registry does not.
registry::Configuration checked_configuration(const std::filesystem::path& file) {
  auto configuration = registry::load_configuration(file);
  for (const auto& renderer : configuration.renderers) adapters::check_scene_format(renderer);
  return configuration;
}

int refuse_output() {
  fmt::print(stderr, "orbs: standard output cannot be written: {}\n", std::strerror(errno));
  return kBadInput;
}

}  // namespace

std::shared_ptr<std::string> add_configuration_option(CLI::App& command) {
  auto file = std::make_shared<std::string>();
  command
      .add_option("--configuration", *file,
                  "file with suites, renderers and defaults (default: the nearest configuration.json)")
      ->check(not_empty("a file"));
  return file;
}

registry::Configuration read_configuration(const std::string& named, const Program& program) {
  if (!named.empty()) return checked_configuration(named);
  for (const auto& from : {std::filesystem::current_path(), program.folder})
    if (const auto file = registry::nearest_configuration(from)) return checked_configuration(*file);
  throw InputError(fmt::format("there is no configuration.json in {} or above; name one with --configuration",
                               std::filesystem::current_path().string()));
}

std::string joined_list(const std::vector<std::string>& values) {
  return fmt::format("{}", fmt::join(values, ","));
}

int run_program(int argc, char** argv, const std::string& version) {
  try {
    const int status = parse_and_act(argc, argv, version);
    return std::fflush(stdout) == 0 && std::ferror(stdout) == 0 ? status : refuse_output();
  } catch (const InputError& e) {
    fmt::print(stderr, "orbs: {}\n", e.what());
    return kBadInput;
  } catch (const std::exception& e) {
    // fmt::print throws where a full buffer cannot be written.
    if (std::ferror(stdout) != 0) return refuse_output();
    fmt::print(stderr, "orbs: internal error: {}\n", e.what());
    return kOurBug;
  }
}

}  // namespace orbs::cli
