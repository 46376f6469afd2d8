#include "importer/import_scene.h"

#include "importer/lights.h"
#include "importer/nodes.h"
#include "scene/load/load_scene.h"
#include "scene/load/write_scene.h"

#include <fmt/format.h>

namespace orbs::importer {

std::string UniqueNames::add(const std::string& wanted, const std::string& otherwise) {
  const std::string& base = wanted.empty() ? otherwise : wanted;
  auto name = base;
  while (!taken_.insert(name).second) name = fmt::format("{} {}", base, ++counts_[base] + 1);
  return name;
}

namespace {

void name_rest(const Source& source, Report& report) {
  const auto& model = source.model;
  for (std::size_t i = 0; i < model.animations.size(); ++i)
    report.not_understood("animations", "the scene as it rests",
                          place("animation", model.animations[i].name, i));
  for (const auto& [name, value] : model.extensions)
    if (name != "KHR_lights_punctual") report.not_understood(name, "as if it were not there", "the file");
  // What follows from this one stands in the report by itself, unless the extension has no place of its own.
  static const std::set<std::string> kRead{
      "KHR_lights_punctual",    "KHR_materials_emissive_strength", "KHR_materials_ior",
      "KHR_materials_specular", "KHR_materials_transmission",      "KHR_materials_volume",
      "KHR_materials_unlit",    "KHR_texture_transform",           "KHR_mesh_quantization"};
  for (const auto& name : model.extensionsRequired)
    if (!kRead.contains(name))
      report.not_understood("extensions without which the file must not be read", "read without them", name);
}

}  // namespace

scene::Scene import_scene(const std::filesystem::path& file,
                          const std::filesystem::path& folder,
                          const std::string& name,
                          const View& view,
                          Report& report) {
  const Source source = read_source(file);
  Import import{source, report, folder};
  import.scene.name = name;
  const auto nodes = placed_nodes(source, report);
  add_instances(import, nodes);
  add_lights(import, nodes);
  set_camera(import, nodes, view);
  add_sky(import, view.sky);
  name_rest(source, report);
  const auto written = folder / "scene.json";
  scene::write_scene(import.scene, written);
  return with_note(fmt::format("reading what was made of {}", file.string()),
                   [&] { return scene::load_scene(written); });
}

}  // namespace orbs::importer
