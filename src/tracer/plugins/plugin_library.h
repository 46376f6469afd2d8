#pragma once

#include "scene/scene.h"

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <orbs/shape_plugin.h>

/// Shared libraries that bring shapes, by the C functions of include/orbs/shape_plugin.h.
namespace orbs::tracer {

struct CloseLibrary {
  void operator()(void* handle) const;
};

/// A library that is open, and its functions.
struct PluginLibrary {
  std::string name;            // by which scenes call it
  std::filesystem::path file;  // for messages
  std::unique_ptr<void, CloseLibrary> handle;
  decltype(&orbs_shape_create) create = nullptr;
  decltype(&orbs_shape_destroy) destroy = nullptr;
  decltype(&orbs_shape_bounds) bounds = nullptr;
  decltype(&orbs_shape_intersect) intersect = nullptr;
  decltype(&orbs_shape_occluded) occluded = nullptr;  // optional
  decltype(&orbs_shape_sample) sample = nullptr;      // optional
  decltype(&orbs_shape_pdf) pdf = nullptr;            // optional
};

/// By the name that scenes call them by.
using PluginLibraries = std::map<std::string, std::shared_ptr<const PluginLibrary>>;

/// Where plug-ins are looked for: first among the files, then in the folder. Scenes come from strangers and
/// name no places.
struct PluginSources {
  std::vector<std::filesystem::path> files;
  std::filesystem::path folder;  // "": none
};

/// The name of the plug-in in a file: that of the file without "lib" before it and its ending.
std::string plugin_name(const std::filesystem::path& file);

/// InputError if two files would be the same plug-in.
void check_plugin_names(const PluginSources& sources);

/// Opens the library, which runs its initialisers. InputError if it is none or is cut off, is for another
/// version of the header, or lacks a required function.
std::shared_ptr<const PluginLibrary> open_plugin(const std::filesystem::path& file);

/// The file of the library whose initialisers run just now; "" when none do. For whoever wants to say who has
/// ended the program.
std::string plugin_being_opened();

/// Opens the plug-ins that shapes of the scene are by, and no others. InputError if one is not found, and as
/// open_plugin.
PluginLibraries open_plugins(const scene::Scene& scene, const PluginSources& sources);

}  // namespace orbs::tracer
