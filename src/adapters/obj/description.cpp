#include "adapters/obj/description.h"

#include "adapters/obj/lamp_words.h"
#include "adapters/obj/mtl.h"
#include "base/files.h"
#include "json/writer.h"
#include "scene/camera_frame.h"

#include <array>
#include <set>
#include <string>

#include <fmt/format.h>

namespace orbs::adapters::obj {

namespace {

constexpr const char* kConventions =
    "Lengths are metres; y is up; axes are right-handed. Colours and radiances are linear Rec.709, red, green, "
    "blue; radiance is what the pixel shows. A matrix is 16 numbers, row by row, for column vectors. Vertex "
    "normals, interpolated over each triangle, are those of the surface; they say which side is outside.";
constexpr const char* kCameraWords =
    "a pinhole at position that looks at look_at, with up upwards; fov_y_degrees is the whole vertical angle. A "
    "pixel is the mean over its square: a box filter of one pixel. Nothing is clipped near or far";
constexpr const char* kLensWords =
    " It is no pinhole but a thin lens: rays begin at all points of a disk of lens_radius_m around position, across "
    "the view, each as likely, and go through the point that the ray through the middle meets on the plane at "
    "focus_distance_m along the view";
constexpr const char* kShiftWords =
    " The window through which it looks is shifted by shift: in its widths to the right, in its heights upwards";
constexpr const char* kOrthographicWords =
    "orthographic: all rays are parallel to the view, from position to look_at, with up upwards, and begin in the "
    "plane of the position; the image shows view_height_m of that plane. A pixel is the mean over its square: a box "
    "filter of one pixel. Nothing is clipped near or far";
constexpr const char* kLatitudeLongitudeWords =
    "all directions in one image, equirectangular: the view from position to look_at is in the middle, columns are "
    "even steps of longitude, to the right by half a turn at the right edge, rows of latitude, up at the upper edge. "
    "A pixel is the mean over its square of the image: a box filter of one pixel. Nothing is clipped near or far";
constexpr const char* kTraceDepthWords =
    "a light path has at most so many surfaces at which it is reflected or refracted, between the lamp and the "
    "camera; 1 is direct light. Mirrors and glass count. What emits is no such surface";
constexpr const char* kBackgroundWords =
    "radiance of rays that meet no surface, in every direction; it lights the scene";
constexpr const char* kMapWords =
    "radiance of rays that meet no surface, times the image at u = 1/2 + atan2(x, -z) / (2 pi), v = 1/2 + "
    "asin(y) / pi of the direction (x, y, z) = inverse of the matrix times the ray's; u wraps, v is clamped to "
    "the centres of the outermost rows. It lights the scene";
constexpr const char* kTextureWords =
    "its texels multiply the number or the colour beside it; 8-bit files of colours hold sRGB values, and each texel is "
    "decoded first";
constexpr const char* kLinearWords =
    ". Filtered bilinearly, without mip maps. The bottom row of the image has v = 0";
constexpr const char* kNearestWords =
    ". The texel that the place lies in counts alone, nothing is interpolated. The bottom row of the image has v = 0";

constexpr const char* kOpacityWords =
    "a ray meets the surface with this probability and else passes straight on: rays of the camera, scattered ones "
    "and those to lights alike. What passes is no scattering";
constexpr const char* kOpacityTextureWords =
    "the largest channel of its texels multiplies the opacity. The files hold plain numbers";
constexpr const char* kNormalWords =
    "x = 2 r - 1 along increasing u, y = 2 g - 1 along increasing v, both times the strength, z = 2 b - 1 along the "
    "normal n; made unit after filtering. The axes are unit: t is the direction of u made perpendicular to n, and n x "
    "t or its opposite, on the side of increasing v. From behind it is the negative. The files hold plain numbers";
constexpr const char* kHeightWords =
    "the red of its texels times height_m is the height along the normal n of a surface that is not moved: with p "
    "made perpendicular to n, its normal is that of (dp/du + n dh/du) x (dp/dv + n dh/dv), on the side of n. From "
    "behind it is the negative. The files hold plain numbers; dh is the slope between them";

struct MaterialWords {
  const char* operator()(const scene::Lambert&) const {
    return "Lambert's law on both sides: reflected radiance = reflectance / pi * irradiance";
  }
  const char* operator()(const scene::OrenNayar&) const {
    return "Oren and Nayar's model of 1994 in its short form, on both sides; sigma = roughness * pi / 2 radians";
  }
  const char* operator()(const scene::Mirror&) const {
    return "a perfect mirror on both sides: radiance of the mirrored direction times reflectance at all angles";
  }
  const char* operator()(const scene::Glass&) const {
    return "a smooth boundary of glass by Fresnel's formulas for unpolarised light; ior is the index inside over "
           "that outside, and the normals point outside. colour multiplies at every reflection and refraction. "
           "Radiance is divided by the square of (index beyond / index on the viewer's side) when it is refracted";
  }
  const char* operator()(const scene::Ggx&) const {
    return "microfacets on both sides: colour * D * G2 / (4 cos cos), D is GGX with this alpha, which is no square "
           "root, G2 Smith's height-correlated masking (Heitz 2014, eq. 99); no Fresnel factor, one scattering";
  }
  const char* operator()(const scene::RoughGlass&) const {
    return "a rough boundary of glass (Walter et al. 2007, eq. 20 and 21) with GGX of this alpha, which is no square "
           "root; masking is height-correlated in reflection and separable in transmission. Else as smooth glass";
  }
  const char* operator()(const scene::Emission&) const {
    return "emits radiance from both sides, also on other surfaces, and reflects nothing";
  }
  template <class Other>
  const char* operator()(const Other&) const {
    return "";  // material_limit refuses it
  }
};

struct CameraWords {
  const scene::Camera& camera;

  std::string operator()(const scene::Perspective&) const {
    std::string text = kCameraWords;
    if (has_lens(camera)) text += std::string(".") + kLensWords;
    if (is_shifted(camera)) text += std::string(".") + kShiftWords;
    return text;
  }
  std::string operator()(const scene::Orthographic&) const { return kOrthographicWords; }
  std::string operator()(const scene::LatitudeLongitude&) const { return kLatitudeLongitudeWords; }
};

struct CameraNumbers {
  json::Writer& out;
  const scene::Camera& camera;

  void operator()(const scene::Perspective&) const {
    out.member("fov_y_degrees", camera.fov_y_deg);
    if (has_lens(camera))
      out.member("lens_radius_m", camera.aperture_radius_m)
          .member("focus_distance_m", camera.focus_distance_m.value());
    if (is_shifted(camera)) out.key("shift").numbers(std::array{camera.shift.x, camera.shift.y});
  }
  void operator()(const scene::Orthographic& kind) const { out.member("view_height_m", kind.height_m); }
  void operator()(const scene::LatitudeLongitude&) const {}
};

void write_camera(json::Writer& out, const scene::Camera& camera) {
  out.key("camera").begin_object();
  out.member("in_words", std::visit(CameraWords{camera}, camera.projection));
  out.member("position", camera.position_m).member("look_at", camera.look_at_m).member("up", camera.up);
  std::visit(CameraNumbers{out, camera}, camera.projection);
  out.member("width_px", camera.width_px).member("height_px", camera.height_px).end_object();
}

void write_settings(json::Writer& out, const scene::Scene& scene) {
  out.key("trace_depth");
  if (scene.trace_depth >= scene::kUnlimitedDepth)
    out.value("unlimited");
  else
    out.value(scene.trace_depth);
  out.member("trace_depth_in_words", kTraceDepthWords);
}

void write_background(json::Writer& out, const scene::Scene& scene, const std::string& stem) {
  const auto& environment = scene.environment;
  out.key("background").begin_object();
  out.member("in_words", environment.map ? kMapWords : kBackgroundWords);
  out.member("radiance", environment.radiance);
  if (environment.map) {
    out.member("map", texture_file(scene, environment.map->texture, stem));
    out.key("matrix").numbers(environment.map->matrix.m);
  }
  out.member("seen_by_camera", environment.visible_to_camera).end_object();
}

void write_texture(json::Writer& out,
                   const scene::Scene& scene,
                   const char* key,
                   const scene::TextureUse& use,
                   const char* words,
                   const std::string& stem) {
  const auto& texture = texture_at(scene, use);
  out.key(key).begin_object().member("file", texture_file(scene, use.texture, stem));
  out.member("wrap_u", word_of(texture.wrap_u)).member("wrap_v", word_of(texture.wrap_v));
  if (texture.filter == scene::Filter::Nearest) out.member("filter", "nearest");
  if (texture.encoding == scene::Encoding::Linear) out.member("encoding", "linear");
  const bool is_nearest = texture.filter == scene::Filter::Nearest;
  out.member("in_words", std::string(words) + (is_nearest ? kNearestWords : kLinearWords)).end_object();
}

void write_opacity(json::Writer& out,
                   const scene::Scene& scene,
                   const scene::SurfaceDetail& detail,
                   const std::string& stem) {
  if (!lets_rays_pass(detail)) return;
  out.member("opacity", detail.opacity).member("opacity_in_words", kOpacityWords);
  if (const auto& use = detail.opacity_texture)
    write_texture(out, scene, "opacity_texture", *use, kOpacityTextureWords, stem);
}

void write_normals(json::Writer& out,
                   const scene::Scene& scene,
                   const scene::SurfaceDetail& detail,
                   const std::string& stem) {
  if (const auto& map = detail.normal_map) {
    out.member("normal_strength", map->strength);
    write_texture(out, scene, "normal_map", map->texture, kNormalWords, stem);
  }
  if (const auto& map = detail.bump_map) {
    out.member("height_m", map->height_m);
    write_texture(out, scene, "bump_map", map->texture, kHeightWords, stem);
  }
}

void write_materials(json::Writer& out, const scene::Scene& scene, const std::string& stem) {
  const auto names = material_names(scene);
  out.key("materials").begin_array();
  for (const int index : scene::visible_materials(scene)) {
    const auto& model = material_at(scene, index).model;
    out.begin_object().member("name", nth(names, index)).member("type", type_name(model));
    out.member("in_words", std::visit(MaterialWords{}, model));
    std::visit([&](const auto& m) { write(out, scene.spectra, m); }, model);
    if (const auto& use = texture_of(model)) write_texture(out, scene, "texture", *use, kTextureWords, stem);
    write_opacity(out, scene, material_at(scene, index).detail, stem);
    write_normals(out, scene, material_at(scene, index).detail, stem);
    out.end_object();
  }
  out.end_array();
}

void write_parts(json::Writer& out, const scene::Scene& scene, const std::vector<PartPlace>& parts) {
  const auto names = material_names(scene);
  out.key("surfaces").begin_array();
  for (const auto& part : parts)
    out.begin_object().member(part.key, part.name).member("material", nth(names, part.material)).end_object();
  out.end_array();
}

void copy_files(const scene::Scene& scene, const std::string& stem, const std::filesystem::path& folder) {
  std::set<int> textures;
  for (const int index : scene::visible_materials(scene))
    for (const scene::TextureUse& use : texture_uses(material_at(scene, index))) textures.insert(use.texture);
  if (scene.environment.map) textures.insert(scene.environment.map->texture);
  for (const int index : textures)
    write_file(folder / texture_file(scene, index, stem), read_file(nth(scene.textures, index).file));
  for (std::size_t i = 0; i < scene.lights.size(); ++i)
    if (const auto& ies = scene.lights[i].ies)
      write_file(folder / profile_file(i, stem), read_file(ies->file));
}

}  // namespace

void write_description(const scene::Scene& scene,
                       const std::vector<PartPlace>& parts,
                       const std::string& stem,
                       const std::filesystem::path& folder) {
  json::Writer out;
  out.begin_object().member("format", "orbs-description/1").member("scene", scene.name);
  out.member("in_words", kConventions);
  write_camera(out, scene.camera);
  write_settings(out, scene);
  write_background(out, scene, stem);
  out.key("lamps").begin_array();
  for (std::size_t i = 0; i < scene.lights.size(); ++i) write_lamp(out, scene.lights[i], i, stem);
  out.end_array();
  write_materials(out, scene, stem);
  write_parts(out, scene, parts);
  write_file(folder / kDescriptionFile, out.end_object().text());
  copy_files(scene, stem, folder);
}

}  // namespace orbs::adapters::obj
