#pragma once

#include "image/image.h"
#include "scene/scene.h"

#include <filesystem>
#include <map>
#include <string>

/// Textures of HydraCore3, as files of its own formats: its reader of PNG fails on grey images, those of TGA
/// and HDR crash, and both formats of its own begin with the bottom row, as our texture coordinates do.
namespace orbs::adapters::hydra {

/// What a material must say of a texture.
struct TextureEntry {
  int id = 0;              // its position in textures_lib
  bool is_linear = false;  // else the bytes are sRGB
};

/// The texture library and, by their index in the scene, what materials say of its textures.
struct TextureLibrary {
  std::string text;
  std::map<int, TextureEntry> entries;
  int count = 0;
};

/// Writes the textures of the visible materials beside a scene file of this stem. InputError when a file
/// cannot be read or written.
TextureLibrary write_textures(const scene::Scene& scene,
                              const std::filesystem::path& folder,
                              const std::string& stem);

/// Writes an image of linear colours as a further texture; returns its position in the library.
int add_image(TextureLibrary& library,
              const image::Image& image,
              const std::filesystem::path& folder,
              const std::string& name);

/// The child of a colour that is multiplied by the texture.
std::string texture_node(const scene::Scene& scene,
                         const TextureLibrary& library,
                         const scene::TextureUse& use);

}  // namespace orbs::adapters::hydra
