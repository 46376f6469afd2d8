#include "adapters/export.h"
#include "adapters/process/programs.h"
#include "base/error.h"
#include "base/terminal.h"
#include "base/text.h"
#include "cli/options.h"
#include "cli/program.h"
#include "registry/new_renderer.h"
#include "registry/placeholders.h"
#include "run/plan/choose_renderers.h"
#include "run/renderer_version.h"

#include <filesystem>
#include <memory>
#include <string>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace orbs::cli {

namespace {

struct AddOptions {
  registry::NewRenderer added;
  std::string version = "--version";
  bool here = false;
};

// The project's file, which is that of the working folder. A file above it would be hidden by it.
void take_project_file(registry::Configuration& configuration) {
  const auto own = std::filesystem::current_path() / "configuration.json";
  const auto nearest = registry::nearest_configuration(std::filesystem::current_path());
  const bool is_other = nearest && *nearest != own && *nearest == configuration.own_file;
  if (is_other)
    throw InputError(fmt::format(
        "--here: the project's file is {}, and one in this folder would hide it; without --here the "
        "entry goes there",
        nearest->string()));
  configuration.own_file = own;
}

// What the program says of its version, which is tried before the entry is written: "" where it is not there.
// One that was only guessed and that it does not understand is left out.
std::string tried_version(const registry::Configuration& configuration,
                          const Program& program,
                          bool is_given,
                          registry::NewRenderer& added) {
  const auto entry = registry::entry_of(configuration, added);
  const auto found = run::installed_executable(entry, configuration.root, program.folder);
  if (!found || added.version.empty()) return {};
  run::Plan places;
  places.root = configuration.root;
  places.build = program.folder;
  constexpr double kSeconds = 5;
  const auto version = run::renderer_version(
      {entry, *found}, places, {.first_seconds = kSeconds, .second_seconds = kSeconds, .say = {}});
  if (!version.empty() && !version.starts_with("unknown")) return version;
  const auto problem = version.empty() ? fmt::format("did not answer within {} s", kSeconds) : version;
  const auto words = fmt::format("{}", fmt::join(added.version, " "));
  if (is_given)
    throw InputError(
        fmt::format("--version: '{} {}' says no version ({}); name what makes it print one, or '' where "
                    "nothing does; {} is as it was",
                    found->string(), words, problem, configuration.own_file.string()));
  added.version.clear();
  return fmt::format("not told by '{}', so the entry has no \"version_command\"", words);
}

int add(registry::Configuration configuration,
        const AddOptions& options,
        bool has_version,
        const Program& program) {
  if (options.here) take_project_file(configuration);
  auto added = options.added;
  added.version = words_of(options.version);
  const auto version = tried_version(configuration, program, has_version, added);
  const auto entry = registry::add_renderer(configuration, added);
  const auto found = run::installed_executable(entry, configuration.root, program.folder);
  print_clean("added to {}\n", configuration.own_file.string());
  print_clean("  name        {}\n", entry.name);
  print_clean("  executable  {}\n", found ? found->string()
                                          : adapters::program_problem(run::program_name(
                                                entry, configuration.root, program.folder)));
  if (!version.empty()) print_clean("  version     {}\n", version);
  print_clean("  reads       {}\n", entry.format.name);
  print_clean("  declares    {}\n", registry::format_features(entry.support.declares));
  print_clean("  command     {}\n", fmt::join(entry.command.words, " "));
  print_clean(
      "next, in that file:\n"
      "  \"command\"   as its command line is; it may use {{{}}}\n"
      "  \"declares\"  what it can do; what it cannot goes to \"known_limits\", with the reason\n"
      "then: orbs doctor; orbs run -r {}\n",
      fmt::join(registry::command_placeholders(), "}, {"), entry.name);
  return 0;
}

}  // namespace

void add_renderer_command(const command_line::Command& command, const Program& program, Action& action) {
  command.needs_command();
  const auto adding =
      command.add_command("add", "Write a checked entry for a renderer, to be completed by hand");
  const auto configuration = add_configuration_option(adding);
  const auto formats = adapters::scene_formats();
  const auto options = std::make_shared<AddOptions>();
  auto* const added = &options->added;
  adding.add_option("name", added->name, "Its name in lists, tables and folders").required();
  adding.add_option("--executable", added->executable,
                    "Path, or name of a program on PATH (default: the name)");
  adding.add_option("--format", added->scene_format, "Scene format that it reads")
      .one_of({formats.begin(), formats.end()})
      .shows_default();
  adding.add_option("--native-scenes", added->native_scenes,
                    "Ending of scenes written by hand for it, such as xml");
  adding.add_option("--declares", added->declares, "ORB.S levels that it supports").shows_default();
  adding
      .add_option("--version", options->version,
                  "Arguments with which it prints its version, tried before anything is written; '' for none")
      .value_name("WORDS")
      .shows_default();
  adding.add_flag("--here", options->here,
                  "Write into configuration.json of the working folder, which is made where there is none");
  adding.add_option(
      "command", added->command,
      "Program and arguments, after -- (default: those of a renderer with the same format, or "
      "'{executable} {scene} --output {output} --spp {spp} --seed {seed} --threads {threads}')");
  adding.callback([=, &program, &action] {
    action = [=, &program] {
      return add(read_configuration(*configuration, program), *options, adding.is_given("--version"),
                 program);
    };
  });
}

}  // namespace orbs::cli
