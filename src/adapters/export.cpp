#include "adapters/export.h"

#include "adapters/mitsuba/mitsuba.h"
#include "adapters/pbrt/pbrt.h"
#include "adapters/povray/povray.h"
#include "adapters/transports.h"
#include "base/error.h"
#include "base/text.h"
#include "scene/lower.h"
#include "scene/write_scene.h"

#include <cassert>
#include <cmath>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace orbs::adapters {

namespace {

struct Setting {
  const char* name;
  void (*set)(PovraySettings&, double);
  bool is_whole;
};

const std::vector<Setting>& povray_settings_table() {
  static const std::vector<Setting> kTable{
      {"area_grid", [](PovraySettings& s, double x) { s.area_grid = static_cast<int>(x); }, true},
      {"area_split", [](PovraySettings& s, double x) { s.area_split = static_cast<int>(x); }, true},
      {"area_adaptive", [](PovraySettings& s, double x) { s.area_adaptive = static_cast<int>(x); }, true},
      {"photons", [](PovraySettings& s, double x) { s.photons = static_cast<int>(x); }, true},
      {"dispersion_samples", [](PovraySettings& s, double x) { s.dispersion_samples = static_cast<int>(x); },
       true},
      {"radiosity_count", [](PovraySettings& s, double x) { s.radiosity.count = static_cast<int>(x); }, true},
      {"radiosity_error_bound", [](PovraySettings& s, double x) { s.radiosity.error_bound = x; }, false},
  };
  return kTable;
}

const Setting* find_setting(const std::string& name) {
  for (const auto& setting : povray_settings_table())
    if (setting.name == name) return &setting;
  return nullptr;
}

PovraySettings povray_settings(const registry::Renderer& renderer) {
  PovraySettings settings;
  for (const auto& [name, value] : renderer.scene_settings) find_setting(name)->set(settings, value);
  return settings;
}

std::vector<std::string> limits_of_format(const registry::Renderer& renderer, const scene::Scene& scene) {
  switch (renderer.scene_format) {
    case registry::SceneFormat::OrbsScene:
      return {};
    case registry::SceneFormat::Native:
      return {"it reads hand-written scenes only"};
    case registry::SceneFormat::Povray:
      return povray_limits(scene, povray_settings(renderer));
    case registry::SceneFormat::Mitsuba:
      return mitsuba_limits(scene);
    case registry::SceneFormat::Pbrt:
      return pbrt_limits(scene);
  }
  return {};
}

}  // namespace

void check_scene_settings(const registry::Renderer& renderer) {
  constexpr double kHighest = 1e8;
  std::set<std::string> known;
  if (renderer.scene_format == registry::SceneFormat::Povray)
    for (const auto& setting : povray_settings_table()) known.insert(setting.name);
  for (const auto& [name, value] : renderer.scene_settings) {
    if (!known.contains(name))
      throw InputError(
          fmt::format("renderer '{}': scene_settings: the format {} has no setting '{}'{}; it has: {}",
                      renderer.name, scene_format_name(renderer.scene_format), name, closest(name, known),
                      known.empty() ? "none" : fmt::format("{}", fmt::join(known, ", "))));
    const bool plausible = value >= 0 && value <= kHighest;
    if (!plausible || (find_setting(name)->is_whole && value != std::floor(value)))
      throw InputError(fmt::format("renderer '{}': scene_settings: {} is {}; expected a {} from 0 to {}",
                                   renderer.name, name, value,
                                   find_setting(name)->is_whole ? "whole number" : "number", kHighest));
  }
}

std::string scene_file_name(registry::SceneFormat format) {
  switch (format) {
    case registry::SceneFormat::OrbsScene:
      return "scene.json";
    case registry::SceneFormat::Povray:
      return "scene.pov";
    case registry::SceneFormat::Mitsuba:
      return "scene.xml";
    case registry::SceneFormat::Pbrt:
      return "scene.pbrt";
    case registry::SceneFormat::Native:
      return "";
  }
  return {};
}

std::variant<scene::Scene, std::string> prepare_scene(const registry::Renderer& renderer,
                                                      const scene::Scene& scene) {
  auto lowered = scene::lower(scene, registry::feature_codes(renderer.declares));
  if (std::holds_alternative<std::string>(lowered)) return lowered;
  if (auto reason = transport_limit(renderer, scene); !reason.empty()) return reason;
  if (const auto limits = limits_of_format(renderer, std::get<scene::Scene>(lowered)); !limits.empty())
    return limits.front();
  return lowered;
}

void export_scene(const registry::Renderer& renderer,
                  const scene::Scene& prepared,
                  const std::filesystem::path& file) {
  switch (renderer.scene_format) {
    case registry::SceneFormat::OrbsScene:
      scene::write_scene(prepared, file);
      return;
    case registry::SceneFormat::Povray:
      write_povray(prepared, povray_settings(renderer), file);
      return;
    case registry::SceneFormat::Mitsuba:
      write_mitsuba(prepared, file);
      return;
    case registry::SceneFormat::Pbrt:
      write_pbrt(prepared, file);
      return;
    case registry::SceneFormat::Native:
      assert(false && "prepare_scene has given a reason");
      return;
  }
}

}  // namespace orbs::adapters
