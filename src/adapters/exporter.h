#pragma once

#include "registry/placeholders.h"
#include "scene/scene.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace orbs::adapters {

/// Numbers for an exporter, by name: "scene_settings" of configuration.json.
using SceneSettings = std::map<std::string, double>;

/// A number that an exporter takes.
struct SceneSetting {
  const char* name = "";
  bool is_whole = false;
};

/// Channels of a renderer's image that hold the linear Rec.709 colour.
using ImageChannels = std::array<std::string, 3>;
inline const ImageChannels kColourChannels{"R", "G", "B"};

/// A format that scenes are written in.
struct Exporter {
  const char* format = "";      // its word in "scene_format" of configuration.json
  const char* scene_file = "";  // name of the main file that it writes, with the ending that programs know
  std::vector<SceneSetting> settings;
  /// Channels of the image that the exported scene asks for; kColourChannels where there is no function.
  ImageChannels (*image_channels)(const scene::Scene& scene) = nullptr;
  /// One reason for each thing in a lowered scene that cannot be written; empty when there is none. A reason
  /// begins with the object in the scene.
  std::vector<std::string> (*limits)(const scene::Scene& scene, const SceneSettings& settings) = nullptr;
  /// Writes a lowered scene without limits, all files into the folder of `file`. InputError when a file
  /// cannot be read or written.
  void (*write)(const scene::Scene& scene,
                const SceneSettings& settings,
                const std::filesystem::path& file) = nullptr;
  /// The placeholders of commands that only programs of this format know, for these samples per pixel; null
  /// where it has none. The settings may be those of another format, whose renderer reads hand-written scenes
  /// of this one.
  registry::Placeholders (*placeholders)(const scene::Scene& scene,
                                         const SceneSettings& settings,
                                         int spp) = nullptr;
};

/// A name for a comment of one line: characters that end a line or control a terminal become spaces.
inline std::string comment_text(const std::string& name) {
  std::string text = name;
  std::replace_if(
      text.begin(), text.end(), [](unsigned char c) { return std::iscntrl(c) != 0; }, ' ');
  return text;
}

}  // namespace orbs::adapters
