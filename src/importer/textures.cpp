#include "importer/textures.h"

#include "base/files.h"
#include "image/image_io.h"
#include "importer/values.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

namespace orbs::importer {

namespace {

constexpr const char* kTransform = "KHR_texture_transform";

const char* ending_of(std::string_view bytes) {
  if (bytes.starts_with("\x89PNG")) return ".png";
  if (bytes.starts_with("\xff\xd8\xff")) return ".jpg";
  return nullptr;
}

std::string encoded_bytes(const Source& source, const tinygltf::Image& image, const std::string& where) {
  if (!image.image.empty()) return {image.image.begin(), image.image.end()};
  if (image.uri.empty()) refuse(source, where + " has neither a file nor a buffer view");
  return read_beside(source.file, decoded_uri(image.uri), where);
}

const tinygltf::Texture& texture_at(const Import& import, int texture, const std::string& where) {
  return item(import.source, import.source.model.textures, texture, "texture", where);
}

// The image of a texture and its sampler, whatever the image's extension says.
std::optional<image::Image> decoded(Import& import, int index, const std::string& where) {
  const auto& picture = item(import.source, import.source.model.images, index, "image", where);
  const auto name = place("image", picture.name, static_cast<std::size_t>(index));
  const auto bytes = encoded_bytes(import.source, picture, name);
  const char* ending = ending_of(bytes);
  if (ending == nullptr) {
    import.report.not_understood("images that are neither PNG nor JPEG", "no texture there", name);
    return std::nullopt;
  }
  const ScratchFolder scratch("orbs-import");
  const auto file = scratch.path() / (std::string("image") + ending);
  write_file(file, bytes);
  try {
    return image::read_image(file);
  } catch (const InputError& e) {
    // The user does not know the file that the message begins with.
    std::string problem = e.what();
    if (const auto own = file.string() + ": "; problem.starts_with(own)) problem.erase(0, own.size());
    refuse(import.source, fmt::format("{} cannot be read: {}", name, problem));
  }
}

scene::Wrap wrap_of(const Source& source, int code, const std::string& where) {
  if (code == TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE) return scene::Wrap::Clamp;
  if (code == TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT) return scene::Wrap::Mirror;
  if (code != TINYGLTF_TEXTURE_WRAP_REPEAT)
    refuse(source, fmt::format("{} has the wrap mode {}, which glTF has not", where, code));
  return scene::Wrap::Repeat;
}

// Three channels of the picture for red, green and blue.
image::Image picked(const image::Image& picture, const std::array<std::size_t, 3>& channels) {
  image::Image out = image::make_image(picture.width, picture.height, {"R", "G", "B"});
  for (std::size_t i = 0; i < out.pixels.size(); ++i)
    out.pixels[i] = picture.pixels[i / 3 * picture.channel_count() + channels.at(i % 3)];
  return out;
}

int add_texture(Import& import,
                const tinygltf::Texture& wanted,
                const image::Image& texels,
                scene::Encoding encoding,
                const std::string& where) {
  scene::Texture texture = sampled(import.source, wanted.sampler, where);
  const auto number = import.scene.textures.size();
  const auto& source_image = import.source.model.images[static_cast<std::size_t>(wanted.source)];
  texture.name = fmt::format("{} {}", source_image.name.empty() ? "texture" : source_image.name, number);
  texture.file = fmt::format("texture.{}.png", number);
  texture.encoding = encoding;
  write_file(import.folder / texture.file, image::png_bytes(texels));
  import.scene.textures.push_back(std::move(texture));
  return static_cast<int>(number);
}

// The texture that `make` makes of the picture, or made of it before; nothing where it makes none.
template <typename Make>
std::optional<scene::TextureUse> made_use(Import& import,
                                          const tinygltf::TextureInfo& info,
                                          const std::string& where,
                                          const std::string& kind,
                                          const Make& make) {
  if (info.index < 0) return std::nullopt;
  const auto& wanted = texture_at(import, info.index, where);
  const std::tuple key{wanted.source, wanted.sampler, kind};
  auto known = import.textures.find(key);
  if (known == import.textures.end()) {
    const auto picture = read_picture(import, info.index, where);
    const std::optional<image::Image> texels = picture ? make(*picture) : std::nullopt;
    if (!texels) return std::nullopt;
    const auto encoding = kind == "colours" ? scene::Encoding::Srgb : scene::Encoding::Linear;
    known = import.textures.emplace(key, add_texture(import, wanted, *texels, encoding, where)).first;
  }
  return scene::TextureUse{known->second, texture_matrix(import.source, info, where)};
}

}  // namespace

scene::Texture sampled(const Source& source, int index, const std::string& where) {
  scene::Texture texture;
  if (index < 0) return texture;
  const auto& sampler = item(source, source.model.samplers, index, "sampler", where);
  texture.wrap_u = wrap_of(source, sampler.wrapS, where);
  texture.wrap_v = wrap_of(source, sampler.wrapT, where);
  if (sampler.magFilter == TINYGLTF_TEXTURE_FILTER_NEAREST) texture.filter = scene::Filter::Nearest;
  return texture;
}

std::optional<image::Image> read_picture(Import& import, int texture, const std::string& where) {
  const auto& wanted = texture_at(import, texture, where);
  if (wanted.source < 0) {
    import.report.not_understood("textures in a format of an extension", "no texture there", where);
    return std::nullopt;
  }
  return decoded(import, wanted.source, where);
}

std::optional<scene::TextureUse> texture_use(Import& import,
                                             const tinygltf::TextureInfo& info,
                                             const std::string& where,
                                             TexelsOf texels) {
  return made_use(import, info, where, texels == TexelsOf::Colours ? "colours" : "numbers",
                  [](const image::Image& picture) -> std::optional<image::Image> {
                    return picked(picture, image::texture_channels(picture));
                  });
}

std::optional<scene::TextureUse> alpha_use(Import& import,
                                           const tinygltf::TextureInfo& info,
                                           const std::string& where,
                                           const std::optional<double>& cutoff) {
  const auto kind = cutoff ? fmt::format("alpha from {}", *cutoff) : "alpha";
  return made_use(import, info, where, kind, [&](const image::Image& picture) -> std::optional<image::Image> {
    const auto found = std::find(picture.channels.begin(), picture.channels.end(), "A");
    if (found == picture.channels.end()) return std::nullopt;
    const auto alpha = static_cast<std::size_t>(found - picture.channels.begin());
    auto texels = picked(picture, {alpha, alpha, alpha});
    for (float& value : texels.pixels)
      if (cutoff) value = static_cast<double>(value) < *cutoff ? 0.0F : 1.0F;
    return texels;
  });
}

int coordinate_set(const tinygltf::TextureInfo& info) {
  const auto transform = info.extensions.find(kTransform);
  if (transform != info.extensions.end())
    if (const auto set = number_in(transform->second, "texCoord")) return static_cast<int>(*set);
  return info.texCoord;
}

// The extension computes, with s, t the scale and r the rotation,
//   u'     = s cos(r) u + t sin(r) v_top + offset
//   v_top' = -s sin(r) u + t cos(r) v_top + offset,
// with v_top = 1 - v. See texture_transform_of of the exporter for its sines.
Mat4 texture_matrix(const Source& source, const tinygltf::TextureInfo& info, const std::string& where) {
  const auto found = info.extensions.find(kTransform);
  if (found == info.extensions.end()) return {};
  const auto offset = numbers_in(found->second, "offset", {0, 0});
  const auto scale = numbers_in(found->second, "scale", {1, 1});
  const double angle = number_in(found->second, "rotation").value_or(0);
  const double s = scale[0];
  const double t = scale[1];
  if (s == 0 || t == 0) refuse(source, where + " has a texture that is scaled by 0");
  const double sine = std::sin(angle);
  const double cosine = std::cos(angle);
  return {{s * cosine, -t * sine, 0, t * sine + offset[0], s * sine, t * cosine, 0,
           1 - t * cosine - offset[1], 0, 0, 1, 0, 0, 0, 0, 1}};
}

}  // namespace orbs::importer
