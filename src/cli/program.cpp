#include "cli/program.h"

#include "base/error.h"
#include "base/terminal.h"
#include "base/text.h"
#include "base/text_table.h"

#include <algorithm>
#include <array>
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

}  // namespace

void add_commands(const command_line::Command& all, const Program& program, Action& action) {
  all.needs_command();
  for (const auto& command : commands())
    command.add(all.add_command(command.name, command.summary, command.group), program, action);
}

namespace {

int parse_and_act(int argc, char** argv, const std::string& version) {
  Program program{version, own_folder(), {argv, argv + argc}};
  const command_line::Program parser{
      "orbs",
      "Renders small test scenes with every configured renderer, compares the images with references, "
      "and says which requirements each renderer meets.",
      "orbs " + version};
  const auto all = parser.command();
  Action action;
  add_commands(all, program, action);
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

std::string called_as(const std::vector<std::string>& command_line) {
  if (command_line.empty() || command_line[0].find('/') == std::string::npos) return "orbs";
  const auto program = std::filesystem::absolute(command_line[0]).lexically_normal();
  const auto near = program.lexically_proximate(std::filesystem::current_path()).string();
  if (near.starts_with("..")) return program.string();
  return near.find('/') == std::string::npos ? "./" + near : near;
}

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

// Each is defined in the file of its name: add_bench_command in bench_command.cpp, which may be in a folder.
using AddCommand = void(const command_line::Command& command, const Program& program, Action& action);
AddCommand add_run_command, add_serve_command, add_report_command, add_compare_command;
AddCommand add_doctor_command, add_list_command, add_effects_command;
AddCommand add_renderer_command, add_reference_command, add_completion_command;
AddCommand add_probe_command, add_qualify_command, add_bench_command, add_effect_cost_command;
AddCommand add_sensitivity_command, add_cost_command, add_stability_command, add_compare_runs_command;
AddCommand add_history_command, add_merge_command, add_submit_command, add_export_command;
AddCommand add_judge_command, add_manual_command, add_import_command, add_explain_command;
AddCommand add_render_command, add_open_command, add_card_command;

namespace {

constexpr const char* kResults = "Run and see results";
constexpr const char* kLookUp = "Look up what there is";
constexpr const char* kSetUp = "Set up";
constexpr const char* kStudies = "Studies";

constexpr std::array kCommands{
    Command{"run", kResults, "Render a suite and judge the images", add_run_command},
    Command{"merge", kResults, "Put the shards of a run together", add_merge_command},
    Command{"submit", kResults, "Render a suite on a cluster", add_submit_command},
    Command{"export", kResults, "Write the scenes of a suite, to be rendered elsewhere", add_export_command},
    Command{"judge", kResults, "Judge images that were rendered from an export", add_judge_command},
    Command{"render", kResults, "Render one image with one renderer, and judge nothing", add_render_command},
    Command{"open", kResults, "Show a reference and what renderers made of it in an image viewer",
            add_open_command},
    Command{"card", kResults,
            "Say of one renderer whether it is right, what that costs, and whether it stays so",
            add_card_command},
    Command{"serve", kResults, "Show runs as a page in the browser, even while they go on",
            add_serve_command},
    Command{"report", kResults, "Write the page of a run as one HTML file", add_report_command},
    Command{"compare", kResults, "Compare two images by every metric, and tell bias from noise",
            add_compare_command},
    Command{"explain", kResults, "Find the typical mistake that makes an image as wrong as it is",
            add_explain_command},
    Command{"compare-runs", kResults, "Compare two runs: significant regressions and improvements",
            add_compare_runs_command},
    Command{"history", kResults, "Show verdicts, errors and times over many runs, and where they changed",
            add_history_command},
    Command{"doctor", kLookUp, "List the renderers: what is installed, its version, what it declares",
            add_doctor_command},
    Command{"list", kLookUp, "List suites, renderers, requirements, cases and scenes", add_list_command},
    Command{"effects", kLookUp, "Show which effects of light each scene calls for, and why",
            add_effects_command},
    Command{"renderer", kSetUp, "Add a renderer to configuration.json", add_renderer_command},
    Command{"import", kSetUp, "Make a case of a scene of your own, from a file of glTF", add_import_command},
    Command{"reference", kSetUp, "Render references with the built-in tracer", add_reference_command},
    Command{"completion", kSetUp, "Print the completion of commands and options for a shell",
            add_completion_command},
    Command{"manual", kSetUp, "Print the manual page", add_manual_command},
    Command{"probe", kStudies, "Check that each renderer places camera, geometry and textures correctly",
            add_probe_command},
    Command{"qualify", kStudies, "Check that each gate rejects faulty images and accepts a good one",
            add_qualify_command},
    Command{"sensitivity", kStudies,
            "Measure which slight faults pass silently, and the rate of false alarms",
            add_sensitivity_command},
    Command{"cost", kStudies, "Measure how long each renderer takes to a given error", add_cost_command},
    Command{"stability", kStudies, "Metamorphic tests: transform scenes in known ways and check the images",
            add_stability_command},
    Command{"bench", kStudies, "Measure speed and noise of renderers side by side", add_bench_command},
    Command{"effect-cost", kStudies,
            "Measure what each effect of light costs, and what leaving it out changes",
            add_effect_cost_command},
};

}  // namespace

std::span<const Command> commands() { return kCommands; }

namespace {

// The innermost command that was given, and its words: "renderer add".
std::pair<command_line::Command, std::string> chosen_command(command_line::Command command) {
  std::string words;
  for (auto inner = command.chosen(); inner; inner = command.chosen()) {
    command = *inner;
    words += command.name() + " ";
  }
  return {command, words};
}

std::string unexpected(std::string_view word,
                       const command_line::Command& command,
                       const std::string& words) {
  std::set<std::string> known;
  for (const auto& option : command.options())
    for (const auto& name : option.long_names) known.insert("--" + name);
  const std::string name(word.substr(0, word.find('=')));
  if (!name.starts_with('-'))
    return fmt::format("'orbs {}' takes no further argument '{}'", trim(words), name);
  return fmt::format("'orbs {}' has no option {}{}", trim(words), name, closest(name, known));
}

// CLI11's "<option>: x not in {a,b}".
std::string expected_value(const std::string& text) {
  constexpr std::string_view kList = " not in {";
  const auto colon = text.find(": ");
  if (colon == std::string::npos) return text;
  const auto option = text.substr(0, colon + 2);
  const auto rest = text.substr(colon + 2);
  if (const auto at = rest.find(kList); at != std::string::npos && rest.ends_with('}')) {
    const auto words = split(rest.substr(at + kList.size(), rest.size() - at - kList.size() - 1), ',');
    const auto found = rest.substr(0, at);
    return fmt::format("{}expected one of {}, not '{}'{}", option, fmt::join(words, ", "), found,
                       closest(found, {words.begin(), words.end()}));
  }
  if (rest.find(" required ") != std::string::npos && rest.ends_with(" missing"))
    return option + "needs a value";
  return text;
}

}  // namespace

std::string parse_complaint(const command_line::Parsed& parsed, const command_line::Command& program) {
  const auto [command, words] = chosen_command(program);
  auto text = parsed.problem;
  if (parsed.has_extras) {
    const auto found = words_of(text.substr(text.find(": ") + 1));
    // The words that follow an unknown option belong to it and are not complained about.
    const auto option =
        std::find_if(found.begin(), found.end(), [](const auto& word) { return word.starts_with('-'); });
    if (!found.empty()) text = unexpected(option == found.end() ? found.front() : *option, command, words);
  } else if (text == "A subcommand is required") {
    std::vector<std::string> names;
    for (const auto& inner : command.commands()) names.push_back(inner.name());
    text = fmt::format("'orbs{}{}' needs a command; there {} {}", words.empty() ? "" : " ", trim(words),
                       names.size() == 1 ? "is" : "are", fmt::join(names, ", "));
  } else {
    text = expected_value(text);
  }
  return fmt::format("{}; 'orbs {}--help' lists the options", text, words);
}

}  // namespace orbs::cli
