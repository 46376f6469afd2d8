#include "run/plan/choose_renderers.h"

#include "adapters/export.h"
#include "adapters/process/programs.h"
#include "adapters/transports.h"
#include "base/error.h"
#include "registry/filters.h"
#include "registry/image_size.h"
#include "registry/placeholders.h"
#include "registry/renderer_variants.h"

#include <algorithm>
#include <system_error>

#include <fmt/format.h>

namespace orbs::run {

namespace {

void take_executable(ChosenRenderer& chosen, const std::string& given) {
  auto found = adapters::find_program(given);
  if (!found)
    throw InputError(fmt::format("{}; -e needs the program of renderer '{}'",
                                 adapters::program_problem(given), chosen.entry.name));
  chosen.executable = *found;
}

// In full, itself or its entry, and not by a pattern.
bool is_named(const registry::Renderer& renderer, const std::vector<std::string>& patterns) {
  return std::find(patterns.begin(), patterns.end(), renderer.name) != patterns.end() ||
         std::find(patterns.begin(), patterns.end(), renderer.variant_of) != patterns.end();
}

[[noreturn]] void refuse_elsewhere(const registry::Renderer& renderer) {
  throw InputError(fmt::format(
      "renderer '{0}' is elsewhere, says its entry: orbs export -r {0} writes its scenes, and orbs judge "
      "judges the images that come back; to start a program here, name it with -e",
      renderer.name));
}

// At every size and for every scene that has its own, so that a misspelled name is an error of the first run.
void check_all_settings(const registry::Renderer& renderer) {
  for (const auto divisor : registry::kSizeDivisors) {
    const auto sized = registry::at_size(renderer, divisor);
    adapters::check_scene_settings(sized);
    for (const auto& [scene, settings] : renderer.format.settings_of_scenes)
      adapters::check_scene_settings(registry::for_scene(sized, scene));
  }
}

}  // namespace

std::string program_name(const registry::Renderer& renderer,
                         const std::filesystem::path& root,
                         const std::filesystem::path& build) {
  return registry::fill_placeholders(renderer.command.executable,
                                     {{"root", root.string()}, {"build", build.string()}});
}

std::optional<std::filesystem::path> installed_executable(const registry::Renderer& renderer,
                                                          const std::filesystem::path& root,
                                                          const std::filesystem::path& build) {
  return adapters::find_program(program_name(renderer, root, build));
}

void choose_renderers(const registry::Configuration& configuration, Plan& plan) {
  const auto& all = configuration.renderers;
  const auto names = registry::chosen_renderers(configuration, plan.settings.renderers);
  const auto patterns = registry::patterns_of(plan.settings.renderers);
  if (!plan.settings.executable.empty() && names.size() != 1)
    throw InputError(fmt::format(
        "-e/--exec is the program of one renderer, but {} are chosen; name one with -r", names.size()));
  for (const auto& renderer : all) {
    if (std::find(names.begin(), names.end(), renderer.name) == names.end()) continue;
    ChosenRenderer chosen{registry::at_size(renderer, plan.settings.size_divisor), {}};
    check_all_settings(renderer);
    adapters::check_transports(renderer);
    if (plan.place == RenderPlace::Elsewhere) {
      chosen.executable = program_name(renderer, plan.root, plan.build);
    } else if (!plan.settings.executable.empty()) {
      take_executable(chosen, plan.settings.executable);
    } else if (renderer.command.is_elsewhere) {
      if (is_named(renderer, patterns)) refuse_elsewhere(renderer);
      continue;
    } else if (const auto found = installed_executable(renderer, plan.root, plan.build)) {
      chosen.executable = *found;
    } else if (is_named(renderer, patterns)) {
      throw InputError(fmt::format("renderer '{}': {}; install it, or name another program with -e",
                                   renderer.name,
                                   adapters::program_problem(program_name(renderer, plan.root, plan.build))));
    } else {
      plan.left_out.push_back(
          {renderer.name, adapters::program_problem(program_name(renderer, plan.root, plan.build))});
      continue;
    }
    plan.renderers.push_back(std::move(chosen));
  }
  if (plan.renderers.empty())
    throw InputError(fmt::format(
        "no renderer is left: of those that '{}' chooses none is installed; 'orbs doctor' says more",
        plan.settings.renderers));
}

bool is_built_in(const Plan& plan, const ChosenRenderer& renderer) {
  std::error_code ignored;
  return std::filesystem::equivalent(renderer.executable, plan.build / "orbs-tracer", ignored);
}

void refuse_missing_programs(const Plan& plan) {
  if (plan.place == RenderPlace::Elsewhere) return;
  for (const auto& renderer : plan.renderers) {
    const auto& program = renderer.entry.command.words.front();
    if (!registry::uses_placeholder(program, "executable") && !adapters::find_program(program))
      throw InputError(
          fmt::format("renderer '{}': its command starts '{}', which is not there; begin with {{executable}}",
                      renderer.entry.name, program));
  }
}

}  // namespace orbs::run
