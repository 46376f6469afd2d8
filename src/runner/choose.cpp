#include "runner/choose.h"

#include "adapters/export.h"
#include "adapters/process/programs.h"
#include "adapters/transports.h"
#include "base/error.h"
#include "registry/filters.h"
#include "registry/placeholders.h"

#include <algorithm>
#include <set>

#include <fmt/format.h>

namespace orbs::runner {

namespace {

using registry::Case;

template <typename Items, typename NameOf>
std::vector<std::string> names_of(const Items& items, NameOf&& name_of) {
  std::vector<std::string> names;
  for (const auto& item : items)
    if (const auto name = name_of(item); std::find(names.begin(), names.end(), name) == names.end())
      names.push_back(name);
  return names;
}

// The images of a case that are chosen, and the scenes that chosen differences are made from.
Case with_images(const Case& whole, const std::set<std::string>& chosen) {
  Case part = whole;
  auto needed = chosen;
  std::erase_if(part.differences, [&](const auto& difference) { return !chosen.contains(difference.name); });
  for (const auto& difference : part.differences) needed.insert({difference.of, difference.minus});
  std::erase_if(part.scenes, [&](const auto& scene) { return !needed.contains(scene.name); });
  const auto gone = [&](const std::string& name) { return !needed.contains(name); };
  std::erase_if(part.masks, [&](const auto& mask) { return gone(mask.target); });
  std::erase_if(part.pixel_checks, [&](const auto& check) { return gone(check.target); });
  std::erase_if(part.path_shares, [&](const auto& share) { return gone(share.scene); });
  return part;
}

void take_executable(ChosenRenderer& chosen, const std::string& given) {
  auto found = adapters::find_program(given);
  if (!found)
    throw InputError(
        fmt::format("{}: is not there or cannot be executed; -e needs the program of renderer '{}'", given,
                    chosen.entry.name));
  chosen.executable = *found;
}

}  // namespace

std::vector<Case> choose_cases(const std::vector<Case>& all, const registry::Defaults& settings) {
  const auto cases =
      registry::select_names(names_of(all, [](const Case& c) { return c.name; }), settings.cases, "case");
  const auto requirements = registry::select_names(names_of(all, [](const Case& c) { return c.requirement; }),
                                                   settings.requirements, "requirement");
  std::vector<std::string> all_targets;
  for (const auto& one_case : all)
    for (const auto& name : registry::target_names(one_case)) all_targets.push_back(name);
  const auto images = registry::select_names(all_targets, settings.scenes, "scene");
  const auto holds = [](const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  std::vector<Case> chosen;
  for (const auto& one_case : all) {
    if (!holds(cases, one_case.name) || !holds(requirements, one_case.requirement)) continue;
    auto part = with_images(one_case, {images.begin(), images.end()});
    if (!part.scenes.empty()) chosen.push_back(std::move(part));
  }
  if (chosen.empty())
    throw InputError(
        fmt::format("no scene is left: nothing matches case '{}', requirement '{}' and scene '{}' at once",
                    settings.cases, settings.requirements, settings.scenes));
  return chosen;
}

std::string program_name(const registry::Renderer& renderer,
                         const std::filesystem::path& root,
                         const std::filesystem::path& build) {
  return registry::fill_placeholders(renderer.executable,
                                     {{"root", root.string()}, {"build", build.string()}});
}

std::optional<std::filesystem::path> installed_executable(const registry::Renderer& renderer,
                                                          const std::filesystem::path& root,
                                                          const std::filesystem::path& build) {
  return adapters::find_program(program_name(renderer, root, build));
}

void choose_renderers(const registry::Configuration& configuration, Plan& plan) {
  const auto& all = configuration.renderers;
  const auto names = registry::select_names(names_of(all, [](const auto& r) { return r.name; }),
                                            plan.settings.renderers, "renderer");
  const auto patterns = registry::patterns_of(plan.settings.renderers);
  if (!plan.settings.executable.empty() && names.size() != 1)
    throw InputError(fmt::format(
        "-e/--exec is the program of one renderer, but {} are chosen; name one with -r", names.size()));
  for (const auto& renderer : all) {
    if (std::find(names.begin(), names.end(), renderer.name) == names.end()) continue;
    adapters::check_scene_settings(renderer);
    adapters::check_transports(renderer);
    ChosenRenderer chosen{renderer, {}};
    if (!plan.settings.executable.empty()) {
      take_executable(chosen, plan.settings.executable);
    } else if (const auto found = installed_executable(renderer, plan.root, plan.build)) {
      chosen.executable = *found;
    } else if (std::find(patterns.begin(), patterns.end(), renderer.name) != patterns.end()) {
      throw InputError(
          fmt::format("renderer '{}': there is no program '{}' here; install it, or name another with -e",
                      renderer.name, program_name(renderer, plan.root, plan.build)));
    } else {
      plan.left_out.push_back({renderer.name, fmt::format("there is no program '{}' here",
                                                          program_name(renderer, plan.root, plan.build))});
      continue;
    }
    plan.renderers.push_back(std::move(chosen));
  }
  if (plan.renderers.empty())
    throw InputError(fmt::format(
        "no renderer is left: of those that '{}' chooses none is installed; 'orbs doctor' says more",
        plan.settings.renderers));
}

}  // namespace orbs::runner
