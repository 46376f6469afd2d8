#pragma once

#include "base/matrix.h"
#include "image/image.h"
#include "importer/import.h"

#include <optional>
#include <string>

namespace orbs::importer {

/// The numbers of an image as they are stored, for the textures that are no colours.
std::optional<image::Image> read_picture(Import& import, int texture, const std::string& where);

/// A texture without an image: how the sampler of this index, -1 the default one, looks into it.
scene::Texture sampled(const Source& source, int index, const std::string& where);

/// What the texels of a texture are.
enum class TexelsOf { Colours, Numbers };

/// A texture of a material, its image written as PNG beside the scene. Nothing where there is none, or it is
/// of a kind that is not read, which the report then says. InputError if its image is not there or broken.
std::optional<scene::TextureUse> texture_use(Import& import,
                                             const tinygltf::TextureInfo& info,
                                             const std::string& where,
                                             TexelsOf texels = TexelsOf::Colours);

/// The alpha of a texture as numbers, or with a cutoff 1 where it is that or more, else 0. Nothing without a
/// texture or without alpha in it.
std::optional<scene::TextureUse> alpha_use(Import& import,
                                           const tinygltf::TextureInfo& info,
                                           const std::string& where,
                                           const std::optional<double>& cutoff);

/// What KHR_texture_transform does to coordinates whose v is 0 in the bottom row.
Mat4 texture_matrix(const Source& source, const tinygltf::TextureInfo& info, const std::string& where);

/// The set of coordinates that a texture uses: TEXCOORD_0 or another.
int coordinate_set(const tinygltf::TextureInfo& info);

}  // namespace orbs::importer
