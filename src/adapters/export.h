#pragma once

#include "adapters/exporter.h"
#include "registry/configuration.h"
#include "scene/scene.h"

#include <filesystem>
#include <set>
#include <string>
#include <variant>

namespace orbs::adapters {

/// InputError when `scene_format` of the renderer is no word of scene_formats().
void check_scene_format(const registry::Renderer& renderer);

/// InputError when `scene_settings` of the renderer holds a name that the exporter of its format does not
/// know, or a value that makes no sense there.
void check_scene_settings(const registry::Renderer& renderer);

/// The scene in the form that the renderer can read: lowered to what it declares, with an origin of
/// coordinates near its camera unless the setting "origin_near_camera" is 0, and checked against the limits
/// of the format; or the reason why there is none.
std::variant<scene::Scene, std::string> prepare_scene(const registry::Renderer& renderer,
                                                      const scene::Scene& scene);

/// Name of the exported scene file of a job, with the ending that programs of the format know; "" where
/// nothing is exported.
std::string scene_file_name(const std::string& format);

/// Channels that hold R, G and B in the image that a renderer makes of the exported scene.
ImageChannels image_channels(const std::string& format, const scene::Scene& scene);

/// Writes a prepared scene in the renderer's format, everything into the folder of `file`.
void export_scene(const registry::Renderer& renderer,
                  const scene::Scene& prepared,
                  const std::filesystem::path& file);

/// All exporters. To add one: its folder, and its line in this table.
const std::vector<Exporter>& exporters();

/// The exporter of that format; nullptr when there is none.
const Exporter* find_exporter(const std::string& format);

/// The words that "scene_format" of configuration.json may hold: those of the exporters, and "native".
std::set<std::string> scene_formats();

}  // namespace orbs::adapters
