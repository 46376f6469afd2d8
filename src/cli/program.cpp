#include "cli/program.h"

#include "base/error.h"
#include "base/text.h"
#include "cli/action.h"
#include "cli/command_table.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <exception>
#include <memory>
#include <set>
#include <string>
#include <string_view>

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

// CLI11 would only say that a command is missing.
void refuse_unknown_command(const CLI::App& app, int argc, char** argv) {
  if (argc < 2 || argv[1][0] == '-') return;
  std::set<std::string> names;
  for (const auto* command : app.get_subcommands({})) names.insert(command->get_name());
  if (!names.contains(argv[1]))
    throw InputError(fmt::format("there is no command '{}'{}; there are: {}", argv[1],
                                 closest(argv[1], names), fmt::join(names, ", ")));
}

// CLI11 writes the value that a flag sets behind its name, "--no-log{false}", which nobody can type.
class HelpFormatter : public CLI::Formatter {
 public:
  std::string make_option_name(const CLI::Option* option, bool is_positional) const override {
    constexpr std::string_view kValue = "{false}";
    auto name = CLI::Formatter::make_option_name(option, is_positional);
    if (const auto at = name.find(kValue); at != std::string::npos) name.erase(at, kValue.size());
    return name;
  }
};

int parse_and_act(int argc, char** argv, const std::string& version) {
  Program program{version, own_folder(), {argv, argv + argc}};
  CLI::App app{
      "Renders small test scenes with every configured renderer, compares the images with references,\n"
      "and says which requirements each renderer meets."};
  app.formatter(std::make_shared<HelpFormatter>());
  app.get_formatter()->label("SUBCOMMAND", "COMMAND");
  app.name("orbs");
  app.set_version_flag("--version", "orbs " + version);
  app.require_subcommand(1);
  Action action;
  for (const auto& command : commands())
    command.add(*app.add_subcommand(command.name, command.summary)->group(command.group), program, action);
  // Last, since commands inherit the footer that the program has when they are added.
  app.footer(
      "First steps:\n"
      "  orbs doctor                 lists the renderers that are installed\n"
      "  orbs run -c 'm*' -r orbs    renders and judges some cases with the built-in tracer\n"
      "  orbs serve                  shows the results in the browser\n"
      "'orbs COMMAND --help' shows the options of a command.");
  refuse_unknown_command(app, argc, argv);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    if (e.get_exit_code() == 0) return app.exit(e);
    const auto chosen = app.get_subcommands();
    const std::string command = chosen.empty() ? "" : chosen.front()->get_name() + " ";
    throw InputError(fmt::format("{}; 'orbs {}--help' lists the options", e.what(), command));
  }
  return action();
}

int refuse_output() {
  fmt::print(stderr, "orbs: standard output cannot be written: {}\n", std::strerror(errno));
  return kBadInput;
}

}  // namespace

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
