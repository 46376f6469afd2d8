#include "adapters/pbrt/pbrt.h"

#include "adapters/detail_images.h"
#include "adapters/exporter.h"
#include "adapters/format_limits.h"
#include "adapters/material_meshes.h"
#include "adapters/mirrored_image.h"
#include "adapters/pbrt/colours.h"
#include "adapters/pbrt/directives.h"
#include "adapters/pbrt/lights.h"
#include "adapters/pbrt/materials.h"
#include "adapters/pbrt/profile_image.h"
#include "adapters/pbrt/small_light.h"
#include "adapters/tinted_image.h"
#include "base/files.h"
#include "base/nth.h"
#include "image/image_io.h"
#include "scene/camera_frame.h"
#include "scene/effects/effects.h"
#include "scene/geometry/ply.h"
#include "scene/geometry/uv_frames.h"
#include "scene/lower/lower.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

namespace orbs::adapters {

namespace {

using pbrt::numbers;
using pbrt::transform;

// pbrt's field of view is that of the image's shorter side.
double fov_of_shorter_side_deg(const scene::Camera& camera) {
  if (camera.width_px >= camera.height_px) return camera.fov_y_deg;
  const double half_height = std::tan(camera.fov_y_deg * std::numbers::pi / 360);
  return 360 / std::numbers::pi * std::atan(half_height * camera.width_px / camera.height_px);
}

std::string look_at(const scene::Camera& camera) {
  return fmt::format("Scale -1 1 1\nLookAt {}  {}  {}\n", numbers(camera.position_m),
                     numbers(camera.look_at_m), numbers(camera.up));
}

// Half extents, and the centre.
std::string screen_window(double half_width, double half_height, Vec2d centre) {
  return fmt::format(" \"float screenwindow\" [{} {} {} {}]", centre.x - half_width, centre.x + half_width,
                     centre.y - half_height, centre.y + half_height);
}

// pbrt's camera space is left-handed: the mirrored x of look_at makes a right-handed image.
struct CameraTextOf {
  const scene::Camera& camera;
  scene::CameraFrame frame;

  // The window is 2 high or wide along the image's shorter side, to which the angle belongs.
  std::string operator()(const scene::Perspective&) const {
    const double unit = std::min(frame.half_width, frame.half_height);
    const auto window = scene::is_shifted(camera)
                            ? screen_window(frame.half_width / unit, frame.half_height / unit,
                                            {frame.centre.x / unit, frame.centre.y / unit})
                            : "";
    const auto lens = scene::has_lens(camera)
                          ? fmt::format(" \"float lensradius\" {} \"float focaldistance\" {}",
                                        camera.aperture_radius_m, camera.focus_distance_m.value())
                          : "";
    return fmt::format("{}Camera \"perspective\" \"float fov\" {}{}{}\n", look_at(camera),
                       fov_of_shorter_side_deg(camera), window, lens);
  }
  std::string operator()(const scene::Orthographic&) const {
    return fmt::format("{}Camera \"orthographic\"{}\n", look_at(camera),
                       screen_window(frame.half_width, frame.half_height, {}));
  }
  // Its images begin at the camera's x and go on to z, y is up. So -x is ours forwards and -z to the right.
  std::string operator()(const scene::LatitudeLongitude&) const {
    const std::array axes{-frame.forward, frame.up, -frame.right};
    std::string matrix;  // column by column
    for (const auto member : {&Vec3d::x, &Vec3d::y, &Vec3d::z})
      matrix += fmt::format("{} {} {} 0  ", axes[0].*member, axes[1].*member, axes[2].*member);
    const auto moved = [&](std::size_t i) { return -dot(axes.at(i), camera.position_m); };
    return fmt::format(
        "Transform [{}{} {} {} 1]\nCamera \"spherical\" \"string mapping\" \"equirectangular\"\n", matrix,
        moved(0), moved(1), moved(2));
  }
};

// pbrt moves the world so that its origin is the camera. Floats then resolve the objects before a distant
// camera no better than its distance, and the image moves by parts of a pixel and more. Beyond 16 times the
// reach of the scene from its own origin, which takes four of 24 bits, pbrt is told to leave the world where
// it is.
std::string frame_text(const scene::Scene& scene, const std::vector<MaterialMesh>& meshes) {
  double reach_m = 0;
  const auto meet = [&](Vec3d point, double radius_m) {
    reach_m = std::max(reach_m, length(point) + radius_m);
  };
  for (const MaterialMesh& shown : meshes)
    for (const Mat4& place : shown.places)
      for (const Vec3f p : shown.mesh.positions) meet(transform_point(place, cast<double>(p)), 0);
  for (const scene::Light& light : scene.lights)
    if (has_area(light.shape))
      meet(transform_point(light.matrix, {}),
           length(transform_direction(light.matrix, half_size(light.shape))));
  return length(scene.camera.position_m) > 16 * reach_m ? "Option \"rendercoordsys\" \"world\"\n" : "";
}

// With texture filtering off, bilinear interpolation remains; by default pbrt would choose a coarser image
// far away. Half floats and the clamp of bright samples would change values. The sampler draws exactly as
// many samples as the command line asks for, each pixel by itself; the default, zsobol, rounds down to a
// power of two.
std::string head_text(const scene::Scene& scene, bool is_spectral) {
  const scene::Camera& camera = scene.camera;
  const auto size =
      fmt::format("\"integer xresolution\" {} \"integer yresolution\" {}", camera.width_px, camera.height_px);
  return fmt::format(
      "Option \"disabletexturefiltering\" true\n"
      "{}"
      "Sampler \"independent\" \"integer pixelsamples\" 64\n"
      "PixelFilter \"box\" \"float xradius\" 0.5 \"float yradius\" 0.5\n"
      "{} \"bool savefp16\" false \"float maxcomponentvalue\" 1e30\n"
      "Integrator \"path\" \"integer maxdepth\" {}\n"  // counts scatterings, as trace_depth
      "WorldBegin\n",
      std::visit(CameraTextOf{camera, scene::camera_frame(camera)}, camera.projection),
      is_spectral ? "Film \"rgb\" " + size : pbrt::band_film(size), scene.trace_depth);
}

class Writer {
 public:
  Writer(const scene::Scene& scene, const std::filesystem::path& file)
      : scene_(scene), colours_(scene), folder_(file.parent_path()), stem_(file.stem().string()) {}

  std::string write() {
    const auto meshes = split_by_frames(scene_, material_meshes(scene_));
    std::string text = frame_text(scene_, meshes) + head_text(scene_, colours_.is_spectral);
    if (scene_.environment.radiance != scene::RgbColour{})
      text += fmt::format("LightSource \"infinite\" {}\n",
                          colours_.radiance(scene_.environment.radiance, scene_.environment.spectrum));
    for (const int index : scene::visible_materials(scene_)) {
      if (scene::texture_of(material_at(scene_, index).model))
        write_tinted_channels(scene_, index, folder_, stem_);
      write_detail_images(scene_, index, folder_ / (stem_ + ".pbrt"), MirrorImages::Beside);
      text += pbrt::material_text(colours_, index, stem_, false);
      const bool is_mirrored = std::any_of(meshes.begin(), meshes.end(), [&](const MaterialMesh& shown) {
        return shown.material == index && shown.is_mirrored;
      });
      if (is_mirrored) text += pbrt::material_text(colours_, index, stem_, true);
    }
    for (std::size_t i = 0; i < meshes.size(); ++i) text += mesh_text(meshes[i], i);
    for (std::size_t i = 0; i < scene_.lights.size(); ++i) text += light_text(scene_.lights[i], i);
    return text;
  }

 private:
  std::string light_text(const scene::Light& light, std::size_t index) const {
    const auto profile = fmt::format("{}-light{}.exr", stem_, index);
    if (light.ies)
      image::write_exr(pbrt::profile_image(*light.ies->profile), folder_ / profile, image::Precision::Float,
                       image::Compression::None);
    return pbrt::light_text(colours_, light, profile);
  }

  // pbrt has no emitters in instances. Vertex normals decide which side is inside, as in ORB.S.
  std::string mesh_text(const MaterialMesh& shown, std::size_t index) const {
    const std::string name = fmt::format("mesh{}", index);
    const std::string ply = fmt::format("{}-{}.ply", stem_, name);
    scene::write_ply(shown.mesh, folder_ / ply, scene::PlyContent::Common);
    const std::string shape =
        fmt::format("  NamedMaterial \"{}\"\n  Shape \"plymesh\" \"string filename\" \"{}\"{}\n",
                    pbrt::material_name(shown.material, shown.is_mirrored), ply,
                    pbrt::alpha_text(material_at(scene_, shown.material), shown.material));
    const auto& model = material_at(scene_, shown.material).model;
    const auto* emission = std::get_if<scene::Emission>(&model);
    std::string text = fmt::format("# mesh {}\n", comment_text(shown.mesh.name));
    // In an instance pbrt finds how points move with u and v before the matrix mirrors and stretches them.
    const bool is_raised = material_at(scene_, shown.material).detail.bump_map.has_value();
    if (emission != nullptr || (shown.places.size() == 1 && !is_raised)) {
      const std::string emitter =
          emission == nullptr ? ""
                              : fmt::format("  AreaLightSource \"diffuse\" {} \"bool twosided\" true\n",
                                            colours_.radiance(emission->radiance, emission->spectrum));
      for (const Mat4& place : shown.places)
        text += fmt::format("AttributeBegin\n{}  {}{}AttributeEnd\n", emitter, transform(place), shape);
      return text;
    }
    text += fmt::format("ObjectBegin \"{}\"\n{}ObjectEnd\n", name, shape);
    for (const Mat4& place : shown.places)
      text +=
          fmt::format("AttributeBegin\n  {}  ObjectInstance \"{}\"\nAttributeEnd\n", transform(place), name);
    return text;
  }

  const scene::Scene& scene_;
  pbrt::Colours colours_;
  std::filesystem::path folder_;
  std::string stem_;
};

}  // namespace

void write_pbrt(const scene::Scene& scene, const std::filesystem::path& file) {
  write_file(file, Writer(scene, file).write());
}

Exporter pbrt_exporter() {
  return {.format = "pbrt",
          .scene_file = "scene.pbrt",
          .settings = {},
          .image_channels =
              [](const scene::Scene& scene) {
                return scene::transport(scene) == scene::LightTransport::Rgb ? pbrt::band_channels()
                                                                             : kColourChannels;
              },
          .limits = [](const scene::Scene& scene, const SceneSettings&) { return pbrt_limits(scene); },
          .write = [](const scene::Scene& scene, const SceneSettings&,
                      const std::filesystem::path& file) { write_pbrt(scene, file); }};
}

namespace {

constexpr const char* kName = "pbrt";

// Conductors of a scene are black from behind.
std::string back_limit(const scene::Scene& scene, const MaterialMesh& shown) {
  const auto& material = material_at(scene, shown.material);
  if (!std::holds_alternative<scene::Conductor>(material.model) || is_closed(shown.mesh)) return "";
  return fmt::format(
      "mesh '{}' is of the conductor '{}' and not closed: pbrt's conductors reflect from behind",
      shown.mesh.name, material.name);
}

// Of what moves a point with v pbrt makes normal x (what moves it with u).
std::string bump_limit(const scene::Scene& scene, const MaterialMesh& shown) {
  const auto& material = material_at(scene, shown.material);
  if (!material.detail.bump_map || has_square_frames(shown.mesh)) return "";
  return fmt::format(
      "mesh '{}' has the bump map of '{}' with v that is mirrored, or longer or shorter than u: pbrt takes u "
      "turned by a quarter for v",
      shown.mesh.name, material.name);
}

std::string normal_limit(const scene::Scene& scene, const scene::Material& material) {
  const auto& map = material.detail.normal_map;
  if (!map) return "";
  const scene::Texture& texture = texture_at(scene, map->texture);
  if (texture.wrap_u == scene::Wrap::Repeat && texture.wrap_v == scene::Wrap::Repeat &&
      texture.filter == scene::Filter::Linear)
    return "";
  return fmt::format("texture '{}' of normals does not repeat, or is not interpolated: pbrt's always are",
                     texture.name);
}

std::string reflecting_limit(const scene::Light& light, const std::string& display_name) {
  if (light.reflectance == scene::RgbColour{}) return "";
  return display_name + " reflects where it shines: pbrt's diffuse surfaces reflect on both sides";
}

// pbrt enlarges other images to the next power of two and so blurs their texels.
std::string size_limit(const scene::Texture& texture) {
  const image::Image image = image::read_image(texture.file);
  if (std::has_single_bit(static_cast<unsigned>(image.width)) &&
      std::has_single_bit(static_cast<unsigned>(image.height)))
    return "";
  return fmt::format("texture '{}' has {} x {} pixels: pbrt resamples what is no power of two", texture.name,
                     image.width, image.height);
}

}  // namespace

std::vector<std::string> pbrt_limits(const scene::Scene& scene) {
  std::vector<std::string> reasons = beyond_orbs_limits(scene, kName, pbrt::beyond_orbs());
  const auto note = [&](const std::string& reason) {
    if (!reason.empty()) reasons.push_back(reason);
  };
  const bool is_spectral = scene::transport(scene) != scene::LightTransport::Rgb;
  std::set<int> textures;
  for (const int index : scene::visible_materials(scene)) {
    const scene::Material& material = material_at(scene, index);
    note(pbrt::material_limit(material));
    note(scene::texture_matrices_problem(scene, index));
    note(uv_set_limit(scene, index, kName));
    if (std::holds_alternative<scene::Emission>(material.model)) continue;
    for (const scene::TextureUse& use : scene::texture_uses(material)) textures.insert(use.texture);
    note(normal_limit(scene, material));
  }
  for (const int index : textures) {
    const scene::Texture& texture = nth(scene.textures, index);
    note(wrap_limit(unmirrored(texture), kName));
    note(size_limit(texture));
    if (is_spectral) note(spectral_texture_limit(texture, kName));
  }
  for (std::size_t i = 0; i < scene.lights.size(); ++i) {
    const auto name = scene::display_name("light", scene.lights[i].name, i);
    note(pbrt::light_limit(scene.lights[i], name));
    note(reflecting_limit(scene.lights[i], name));
  }
  const auto meshes = material_meshes(scene);
  for (const MaterialMesh& shown : meshes) {
    note(back_limit(scene, shown));
    note(bump_limit(scene, shown));
  }
  note(pbrt::small_light_limit(scene, meshes));
  return reasons;
}

}  // namespace orbs::adapters
