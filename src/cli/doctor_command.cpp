#include "adapters/process/programs.h"
#include "base/error.h"
#include "base/terminal.h"
#include "base/text.h"
#include "base/text_table.h"
#include "cli/options.h"
#include "cli/program.h"
#include "json/writer.h"
#include "registry/cases.h"
#include "registry/renderer_variants.h"
#include "run/plan/choose_renderers.h"
#include "run/renderer_version.h"

#include <algorithm>
#include <optional>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

namespace orbs::cli {

namespace {

// What is found out about a renderer.
struct Examined {
  const registry::Renderer* entry;
  std::optional<std::filesystem::path> executable;
  std::string problem;  // why there is no executable
  std::string version;
  std::vector<std::string> unknown_scenes;  // sentences on names of scenes that no suite has
};

// The scenes of all suites. None if a suite cannot be read, after printing why.
std::optional<std::set<std::string>> scene_names(const registry::Configuration& configuration) {
  std::set<std::string> names;
  for (const auto& suite : configuration.suites) {
    try {
      for (const auto& one_case : registry::load_cases(suite))
        for (const auto& scene : one_case.scenes) names.insert(scene.name);
    } catch (const InputError& e) {
      print_clean(stderr, "suite {} cannot be read: {}\n", suite.name, e.what());
      return std::nullopt;
    }
  }
  return names;
}

Examined examine(const registry::Renderer& renderer,
                 const run::Plan& places,
                 const std::optional<std::set<std::string>>& scenes) {
  Examined found{&renderer, run::installed_executable(renderer, places.root, places.build), "", "", {}};
  if (renderer.command.is_elsewhere)
    found.problem = "it is elsewhere, for orbs export and orbs judge";
  else if (!found.executable)
    found.problem = adapters::program_problem(run::program_name(renderer, places.root, places.build));
  if (found.executable && !renderer.command.version_command.empty())
    found.version =
        run::renderer_version({renderer, *found.executable}, places,
                              {.say = [](const auto& line) { print_clean(stderr, "{}\n", line); }});
  const auto check_scene = [&](const char* key, const std::string& name) {
    if (scenes && !scenes->contains(name))
      found.unknown_scenes.push_back(
          fmt::format("{}: no suite has a scene '{}'{}", key, name, closest(name, *scenes)));
  };
  for (const auto& [name, settings] : renderer.format.settings_of_scenes)
    check_scene("scene_settings_of_scenes", name);
  return found;
}

// One line each, and what is wrong with an entry.
void print_overview(const std::vector<Examined>& all) {
  std::vector<TableRow> rows;
  for (const auto& found : all) {
    const auto version = found.version.empty() ? "installed" : found.version;
    rows.push_back({found.entry->name, found.executable ? version : "not installed: " + found.problem,
                    found.entry->format.name, registry::format_features(found.entry->support.declares)});
  }
  print_clean("{}", text_table(rows, {}, {terminal_width(STDOUT_FILENO), {}}));
  for (const auto& found : all)
    for (const auto& scene : found.unknown_scenes) print_clean("warning: {}: {}\n", found.entry->name, scene);
  print_clean("orbs doctor -r NAME shows the program of a renderer, and what it cannot do\n");
}

using registry::ValuePlace;

std::string file_of(const std::string& place) { return place.substr(0, place.rfind(':')); }

// The places of values under `prefix`, without it.
std::vector<ValuePlace> places_under(const std::vector<ValuePlace>& all, const std::string& prefix) {
  std::vector<ValuePlace> found;
  for (const auto& [value, place] : all)
    if (value.starts_with(prefix)) found.push_back({value.substr(prefix.size()), place});
  return found;
}

// With those of the values that lie over the lowest file.
void print_files(const registry::Configuration& configuration, const std::vector<ValuePlace>& places) {
  print_clean("configuration  {}\n", configuration.file.string());
  const std::vector<std::filesystem::path> below(configuration.below.rbegin(), configuration.below.rend());
  for (const auto& file : below) print_clean("  over         {}\n", file.string());
  if (below.empty()) return;
  // What a renderer has stands with it.
  for (const auto& [value, place] : places)
    if (!value.starts_with("renderers/") && file_of(place) != below.back().string())
      print_clean("  {}  {}\n", value, place);
}

void print_details(const Examined& found, const std::vector<ValuePlace>& places) {
  const auto& renderer = *found.entry;
  print_clean("{}\n", renderer.name);
  std::vector<TableRow> rows;
  const auto add = [&](const char* what, const std::string& text) { rows.push_back({"", what, text}); };
  add("program", found.executable ? found.executable->string() : "not installed: " + found.problem);
  if (!found.version.empty()) add("version", found.version);
  add("reads",
      renderer.format.native_scenes.empty()
          ? renderer.format.name
          : fmt::format("{}, hand-written scenes *.{}", renderer.format.name, renderer.format.native_scenes));
  // The program must have been built with each of them; a run says which one is missing.
  for (const auto& [transport, word] : renderer.format.transports)
    add("needs", fmt::format("{} for {} light paths", word, transport));
  add("declares", registry::format_features(renderer.support.declares));
  for (const auto& limit : renderer.support.known_limits)
    add("lacks", fmt::format("{}: {}", fmt::join(limit.requirements, ", "), registry::limit_text(limit)));
  add("entry", renderer.place);
  const auto& name = renderer.variant_of.empty() ? renderer.name : renderer.variant_of;
  for (const auto& [value, place] : places_under(places, fmt::format("renderers/{}/", name)))
    if (file_of(place) != file_of(renderer.place)) add("changed", fmt::format("{} in {}", value, place));
  for (const auto& scene : found.unknown_scenes) add("warning", scene);
  print_clean("{}", text_table(rows, {}, {terminal_width(STDOUT_FILENO), {}}));
}

void print_json(const registry::Configuration& configuration,
                const std::vector<ValuePlace>& places,
                const std::vector<Examined>& all) {
  json::Writer out;
  out.begin_object().member("format", "orbs-doctor/1").member("configuration", configuration.file.string());
  std::vector<std::string> below;
  for (const auto& file : configuration.below) below.push_back(file.string());
  out.member("over", below).key("values").begin_object();
  for (const auto& [value, place] : places) out.member(value, place);
  out.end_object();
  out.key("renderers").begin_array();
  for (const auto& found : all) {
    const auto& renderer = *found.entry;
    out.begin_object().member("name", renderer.name).member("installed", found.executable.has_value());
    if (found.executable) out.member("program", found.executable->string());
    if (!found.problem.empty()) out.member("problem", found.problem);
    if (!found.version.empty()) out.member("version", found.version);
    out.member("scene_format", renderer.format.name);
    out.member("declares", registry::format_features(renderer.support.declares))
        .key("known_limits")
        .begin_array();
    for (const auto& limit : renderer.support.known_limits)
      out.begin_object()
          .member("requirements",
                  std::vector<std::string>(limit.requirements.begin(), limit.requirements.end()))
          .member("reason", registry::limit_text(limit))
          .end_object();
    out.end_array().end_object();
  }
  print_raw(stdout, out.end_array().end_object().text());
}

}  // namespace

void add_doctor_command(const command_line::Command& command, const Program& program, Action& action) {
  const auto configuration = add_configuration_option(command);
  const auto chosen = std::make_shared<std::string>();
  command.add_option("-r,--renderer", *chosen, "Only these renderers, with program, needs and known limits")
      .value_name("NAMES")
      .not_empty("a name");
  const auto as_json = std::make_shared<bool>(false);
  command.add_flag("--json", *as_json, "Print everything as JSON, for programs");
  command.callback([=, &program, &action] {
    action = [=, &program] {
      const auto read = read_configuration(*configuration, program);
      const auto values = registry::value_places(read.files);
      run::Plan places;
      places.root = read.root;
      places.build = program.folder;
      places.settings.sandbox = read.defaults.sandbox;
      refuse_without_sandbox(places.settings.sandbox);
      const auto scenes = scene_names(read);
      std::vector<Examined> all;
      const auto names =
          chosen->empty() ? std::vector<std::string>{} : registry::chosen_renderers(read, *chosen);
      for (const auto& renderer : read.renderers)
        if (chosen->empty() || std::find(names.begin(), names.end(), renderer.name) != names.end())
          all.push_back(examine(renderer, places, scenes));
      if (*as_json) {
        print_json(read, values, all);
        return 0;
      }
      if (chosen->empty()) {
        print_files(read, values);
        print_overview(all);
        return 0;
      }
      // What was asked for comes first.
      for (const auto& found : all) print_details(found, values);
      print_files(read, values);
      return 0;
    };
  });
}

}  // namespace orbs::cli
