#include "cli/program.h"

#include "base/error.h"
#include "base/terminal.h"
#include "base/text.h"
#include "base/text_table.h"
#include "cli/action.h"
#include "cli/command_table.h"
#include "cli/parse_complaint.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <exception>
#include <filesystem>
#include <memory>
#include <new>
#include <set>
#include <string>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

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
void refuse_unknown_command(const command_line::Command& all, int argc, char** argv) {
  if (argc < 2 || argv[1][0] == '-') return;
  std::set<std::string> names;
  for (const auto& command : all.commands()) names.insert(command.name());
  if (!names.contains(argv[1]))
    throw InputError(fmt::format("there is no command '{}'{}; there are: {}", argv[1],
                                 closest(argv[1], names), fmt::join(names, ", ")));
}

// Lines of the help that are wider than the terminal, broken between words. What follows starts below the
// description, which the help puts behind at least two blanks.
std::string wrapped_help(const std::string& help, std::size_t width) {
  if (width == 0) return help;
  std::string text;
  for (const auto& line : split(std::string_view(help).substr(0, help.find_last_not_of('\n') + 1), '\n')) {
    const auto begin = std::min(line.find_first_not_of(' '), line.size());
    const auto gap = line.find("  ", begin);
    const auto column =
        gap == std::string::npos ? begin : std::min(line.find_first_not_of(' ', gap), line.size());
    if (display_width(line) <= width || column + 20 > width) {
      text += line + '\n';
      continue;
    }
    const auto parts = wrapped(line.substr(column), width - column);
    text += line.substr(0, column) + parts.front() + '\n';
    for (std::size_t i = 1; i < parts.size(); ++i) text += std::string(column, ' ') + parts[i] + '\n';
  }
  return text;
}

int parse_and_act(int argc, char** argv, const std::string& version) {
  Program program{version, own_folder(), {argv, argv + argc}};
  const command_line::Program parser{
      "orbs",
      "Renders small test scenes with every configured renderer, compares the images with references,\n"
      "and says which requirements each renderer meets.",
      "orbs " + version};
  const auto all = parser.command();
  all.needs_command();
  Action action;
  for (const auto& command : commands())
    command.add(all.add_command(command.name, command.summary, command.group), program, action);
  // Last, since commands inherit the footer that the program has when they are added.
  all.footer(
      "First steps:\n"
      "  orbs doctor                 lists the renderers that are installed\n"
      "  orbs run -c 'm*' -r orbs    renders and judges some cases with the built-in tracer\n"
      "  orbs serve                  shows the results in the browser\n"
      "'orbs COMMAND --help' shows the options of a command.");
  refuse_unknown_command(all, argc, argv);
  const auto parsed = parser.parse(argc, argv);
  if (!parsed.problem.empty()) throw InputError(parse_complaint(parsed, all));
  if (!parsed.text.empty()) {
    print_clean("{}", wrapped_help(parsed.text, static_cast<std::size_t>(terminal_width(STDOUT_FILENO))));
    return 0;
  }
  return action();
}

int refuse_output() {
  print_clean(stderr, "orbs: standard output cannot be written: {}\n", std::strerror(errno));
  return kBadInput;
}

}  // namespace

int run_program(int argc, char** argv, const std::string& version) {
  try {
    const int status = parse_and_act(argc, argv, version);
    return std::fflush(stdout) == 0 && std::ferror(stdout) == 0 ? status : refuse_output();
  } catch (const InputError& e) {
    print_clean(stderr, "orbs: {}\n", e.what());
    return kBadInput;
  } catch (const std::bad_alloc&) {
    print_clean(
        stderr,
        "orbs: there is not enough memory; fewer renders at a time (-j) or smaller images need less\n");
    return kBadInput;
  } catch (const std::filesystem::filesystem_error& e) {
    // A name that is too long, a link that leads to itself, a working folder that is gone.
    print_clean(stderr, "orbs: {}: {}\n", e.path1().empty() ? "the working folder" : e.path1().string(),
                e.code().message());
    return kBadInput;
  } catch (const std::exception& e) {
    // fmt::print throws where a full buffer cannot be written.
    if (std::ferror(stdout) != 0) return refuse_output();
    print_clean(stderr, "orbs: internal error: {}\n", e.what());
    return kOurBug;
  }
}

}  // namespace orbs::cli
