#include "adapters/export.h"

#include "adapters/gltf/gltf.h"
#include "adapters/hydra/hydra.h"
#include "adapters/mitsuba/mitsuba.h"
#include "adapters/obj/obj.h"
#include "adapters/pbrt/pbrt.h"
#include "adapters/povray/povray.h"
#include "adapters/transports.h"
#include "base/error.h"
#include "base/text.h"
#include "registry/configuration.h"
#include "scene/geometry/extent.h"
#include "scene/load/write_scene.h"
#include "scene/lower/lower.h"
#include "scene/relations/motion.h"

#include <cassert>
#include <cmath>
#include <set>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace orbs::adapters {

namespace {

// Of every format. 1: the origin of the coordinates is near the camera, as readers keep them in floats
// (scene/geometry/extent.h), and that of textures near 0. 0: they are the scene's own, which shows what a
// renderer makes of large coordinates; the default of the project's own format, whose readers get the scene
// as it is.
constexpr SceneSetting kOriginNearCamera{.name = "origin_near_camera", .is_whole = true};

std::vector<SceneSetting> settings_of(const Exporter& exporter) {
  auto settings = exporter.settings;
  settings.push_back(kOriginNearCamera);
  return settings;
}

bool moves_origin(const Exporter& exporter, const SceneSettings& settings) {
  const auto setting = settings.find(kOriginNearCamera.name);
  return setting == settings.end() ? exporter.format != std::string_view(registry::kNeutralFormat)
                                   : setting->second != 0;
}

void check_setting(const registry::Renderer& renderer, const SceneSetting& setting, double value) {
  constexpr double kHighest = 1e8;
  const bool is_right = value >= 0 && value <= kHighest && (!setting.is_whole || value == std::floor(value));
  if (!is_right)
    throw InputError(fmt::format("{}: scene_settings: {} is {}; expected a {} from 0 to {}",
                                 entry_name(renderer), setting.name, value,
                                 setting.is_whole ? "whole number" : "number", kHighest));
}

scene::Scene with_origin_near_camera(const scene::Scene& scene) {
  const Vec3d origin = scene::origin_near(scene::extent_of(scene));
  return origin == Vec3d{} ? scene : scene::moved(scene, translation(Vec3d{} - origin));
}

void leave_out_repetitions_of_textures(scene::Scene& scene) {
  for (auto& material : scene.materials)
    std::visit(
        [&](auto& model) {
          if constexpr (requires { model.texture; })
            if (auto& use = model.texture)
              use->matrix = scene::without_repetitions(use->matrix, scene::texture_at(scene, *use));
        },
        material.model);
}

}  // namespace

void check_scene_format(const registry::Renderer& renderer) {
  const auto known = scene_formats();
  if (!known.contains(renderer.format.name))
    throw InputError(fmt::format("{}: scene_format: '{}' is not one of: {}{}", entry_name(renderer),
                                 renderer.format.name, fmt::join(known, ", "),
                                 closest(renderer.format.name, known)));
}

void check_scene_settings(const registry::Renderer& renderer) {
  const auto* exporter = find_exporter(renderer.format.name);
  const auto settings = exporter == nullptr ? std::vector<SceneSetting>{} : settings_of(*exporter);
  std::set<std::string> known;
  for (const auto& setting : settings) known.insert(setting.name);
  for (const auto& [name, value] : renderer.format.settings) {
    if (!known.contains(name))
      throw InputError(fmt::format("{}: scene_settings: the format {} has no setting '{}'{}; it has: {}",
                                   entry_name(renderer), renderer.format.name, name, closest(name, known),
                                   known.empty() ? "none" : fmt::format("{}", fmt::join(known, ", "))));
    for (const auto& setting : settings)
      if (setting.name == name) check_setting(renderer, setting, value);
  }
}

std::string scene_file_name(const std::string& format) {
  const auto* exporter = find_exporter(format);
  return exporter == nullptr ? "" : exporter->scene_file;
}

ImageChannels image_channels(const std::string& format, const scene::Scene& scene) {
  const auto* exporter = find_exporter(format);
  return exporter == nullptr || exporter->image_channels == nullptr ? kColourChannels
                                                                    : exporter->image_channels(scene);
}

std::variant<scene::Scene, std::string> prepare_scene(const registry::Renderer& renderer,
                                                      const scene::Scene& scene) {
  auto lowered = scene::lower(scene, registry::feature_codes(renderer.support.declares));
  if (std::holds_alternative<std::string>(lowered)) return lowered;
  if (auto reason = transport_limit(renderer, scene); !reason.empty()) return reason;
  const auto* exporter = find_exporter(renderer.format.name);
  check_scene_format(renderer);
  if (exporter == nullptr) return "it reads hand-written scenes only";
  auto prepared = std::get<scene::Scene>(std::move(lowered));
  if (moves_origin(*exporter, renderer.format.settings)) {
    prepared = with_origin_near_camera(prepared);
    leave_out_repetitions_of_textures(prepared);
  }
  const auto limits = exporter->limits(prepared, renderer.format.settings);
  if (!limits.empty()) return limits.front();
  return prepared;
}

void export_scene(const registry::Renderer& renderer,
                  const scene::Scene& prepared,
                  const std::filesystem::path& file) {
  const auto* exporter = find_exporter(renderer.format.name);
  assert(exporter != nullptr && "prepare_scene has given a reason");
  exporter->write(prepared, renderer.format.settings, file);
}

namespace {

// 1: the scene file has what the scene calls for. A reader that refuses what it does not know, as it should,
// is not given a key that it did not ask for.
constexpr SceneSetting kCallsFor{.name = "calls_for", .is_whole = true};

Exporter neutral_exporter() {
  return {
      .format = registry::kNeutralFormat,
      .scene_file = "scene.json",
      .settings = {kCallsFor},
      .limits = [](const scene::Scene&, const SceneSettings&) { return std::vector<std::string>{}; },
      .write =
          [](const scene::Scene& scene, const SceneSettings& settings, const std::filesystem::path& file) {
            const auto asked = settings.find(kCallsFor.name);
            scene::write_scene(scene, file, asked != settings.end() && asked->second != 0);
          }};
}

}  // namespace

const std::vector<Exporter>& exporters() {
  static const std::vector<Exporter> kExporters{
      neutral_exporter(), povray_exporter(), mitsuba_exporter(), pbrt_exporter(),
      hydra_exporter(),   gltf_exporter(),   obj_exporter(),     ply_exporter(),
  };
  return kExporters;
}

const Exporter* find_exporter(const std::string& format) {
  for (const auto& exporter : exporters())
    if (exporter.format == format) return &exporter;
  return nullptr;
}

std::set<std::string> scene_formats() {
  std::set<std::string> formats{registry::kNativeFormat};
  for (const auto& exporter : exporters()) formats.insert(exporter.format);
  return formats;
}

}  // namespace orbs::adapters
