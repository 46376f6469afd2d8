#include "adapters/exporters.h"

#include "adapters/mitsuba/mitsuba.h"
#include "adapters/pbrt/pbrt.h"
#include "adapters/povray/povray.h"
#include "registry/configuration.h"
#include "scene/load/write_scene.h"

namespace orbs::adapters {

namespace {

Exporter neutral_exporter() {
  return {.format = registry::kNeutralFormat,
          .scene_file = "scene.json",
          .settings = {},
          .limits = [](const scene::Scene&, const SceneSettings&) { return std::vector<std::string>{}; },
          .write = [](const scene::Scene& scene, const SceneSettings&,
                      const std::filesystem::path& file) { scene::write_scene(scene, file); }};
}

}  // namespace

const std::vector<Exporter>& exporters() {
  static const std::vector<Exporter> kExporters{
      neutral_exporter(),
      povray_exporter(),
      mitsuba_exporter(),
      pbrt_exporter(),
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
