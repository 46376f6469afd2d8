#pragma once

#include "scene/shapes/shape_type.h"

#include <map>
#include <string>

namespace orbs::scene {

/// What a plug-in of the built-in tracer makes of these numbers (include/orbs/shape_plugin.h). The scene
/// holds no place where the plug-in lies, only its name: letters, digits, '-' and '_'. It has no inside.
struct PluginForm {
  static constexpr const char* kType = "plugin";
  static constexpr const char* kWhat = "a plug-in's surface";
  static constexpr const char* kLevel = "S7";
  std::string plugin;
  std::map<std::string, double> numbers;
  bool operator==(const PluginForm&) const = default;
};

void load(ShapeEntry& entry, PluginForm& loaded);
void write(json::Writer& out, const MaterialList& materials, const PluginForm& form);
inline bool is_closed(const PluginForm&) { return false; }
/// The plug-in knows, and only the tracer opens it: the point where the shape is placed stands for it.
inline std::optional<LocalBox> bounds(const PluginForm&) { return LocalBox{}; }
inline std::optional<Mesh> tessellated(const PluginForm&) { return std::nullopt; }

}  // namespace orbs::scene
