#include "adapters/gltf/document.h"

#include "base/nth.h"
#include "json/writer.h"
#include "scene/camera_frame.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <numbers>
#include <set>

#include <fmt/format.h>

namespace orbs::adapters::gltf {

namespace {

using json::Writer;

using Extensions = std::set<std::string>;

constexpr const char* kLights = "KHR_lights_punctual";

// A reader that does not know one of these draws another scene, and must refuse it. KHR_materials_volume
// would be one of them, but Blender 3.4 reads it and does not say so.
const Extensions& required_extensions() {
  static const Extensions kRequired{kLights,
                                    "KHR_materials_emissive_strength",
                                    "KHR_materials_ior",
                                    "KHR_materials_specular",
                                    "KHR_materials_transmission",
                                    "KHR_texture_transform"};
  return kRequired;
}

// The object stays open for what a kind of texture has beside.
void begin_texture_info(Writer& out, const char* key, const TextureInfo& info, Extensions& used) {
  out.key(key).begin_object().member("index", info.texture);
  if (info.uv_set != 0) out.member("texCoord", info.uv_set);
  if (info.transform) {
    used.insert("KHR_texture_transform");
    out.key("extensions").begin_object().key("KHR_texture_transform").begin_object();
    out.key("offset").numbers(info.transform->offset);
    out.member("rotation", info.transform->rotation_rad);
    out.key("scale").numbers(info.transform->scale);
    out.end_object().end_object();
  }
}

void write_texture_info(Writer& out, const char* key, const TextureInfo& info, Extensions& used) {
  begin_texture_info(out, key, info, used);
  out.end_object();
}

// The extensions of a material in the order of their names.
void write_extensions(Writer& out, const Surface& surface, double strength, Extensions& used) {
  const auto extension = [&](const char* name) -> Writer& {
    used.insert(name);
    return out.key(name).begin_object();
  };
  if (strength != 1)
    extension("KHR_materials_emissive_strength").member("emissiveStrength", strength).end_object();
  if (surface.ior) extension("KHR_materials_ior").member("ior", *surface.ior).end_object();
  if (surface.specular != 1) {
    extension("KHR_materials_specular").member("specularFactor", surface.specular);
    // The factor alone says it. Blender 3.4 reads the colour alone.
    if (surface.specular == 0) out.member("specularColorFactor", scene::RgbColour{});
    out.end_object();
  }
  if (!surface.is_glass) return;
  extension("KHR_materials_transmission").member("transmissionFactor", 1).end_object();
  // Light paths ask only whether the thickness is 0: then the surface would be a film that refracts nothing.
  extension("KHR_materials_volume").member("thicknessFactor", 1).end_object();
}

void write_material(Writer& out, const Material& material, Extensions& used) {
  const Surface& surface = material.surface;
  const bool shines = surface.radiance != scene::RgbColour{};
  const double strength = std::max(1.0, largest(surface.radiance));
  const auto& base = surface.base_colour;
  out.begin_object().member("name", material.name);
  out.key("pbrMetallicRoughness").begin_object();
  out.key("baseColorFactor").numbers(std::array{base.x, base.y, base.z, 1.0});
  if (material.texture && !shines) write_texture_info(out, "baseColorTexture", *material.texture, used);
  out.member("metallicFactor", surface.metallic).member("roughnessFactor", surface.roughness).end_object();
  if (shines) {
    const auto [r, g, b] = surface.radiance;
    out.key("emissiveFactor").numbers(std::array{r / strength, g / strength, b / strength});
    if (material.texture) write_texture_info(out, "emissiveTexture", *material.texture, used);
  }
  if (material.normals) {
    begin_texture_info(out, "normalTexture", material.normals->info, used);
    if (material.normals->scale != 1) out.member("scale", material.normals->scale);
    out.end_object();
  }
  // Glass shows both sides of itself anyway.
  if (!surface.is_glass) out.member("doubleSided", true);
  if (strength != 1 || surface.ior || surface.specular != 1 || surface.is_glass) {
    out.key("extensions").begin_object();
    write_extensions(out, surface, strength, used);
    out.end_object();
  }
  out.end_object();
}

void write_mesh(Writer& out, const Mesh& mesh) {
  out.begin_object().member("name", mesh.name).key("primitives").begin_array().begin_object();
  out.key("attributes").begin_object();
  out.member("POSITION", mesh.positions).member("NORMAL", mesh.normals);
  if (mesh.tangents) out.member("TANGENT", *mesh.tangents);
  for (std::size_t set = 0; set < mesh.uvs.size(); ++set)
    out.member(fmt::format("TEXCOORD_{}", set), mesh.uvs[set]);
  out.end_object().member("indices", mesh.triangles).member("material", mesh.material);
  out.end_object().end_array().end_object();
}

// What is as without a transform is left out.
void write_placement(Writer& out, const Placement& placement) {
  const Placement none;
  if (placement.translation != none.translation) out.member("translation", placement.translation);
  if (placement.rotation != none.rotation) out.key("rotation").numbers(placement.rotation);
  if (placement.scale != none.scale) out.member("scale", placement.scale);
}

void write_node(Writer& out, const Node& node) {
  out.begin_object().member("name", node.name).member("mesh", node.mesh);
  write_placement(out, node.placement);
  out.end_object();
}

// A camera of glTF looks along its -Z, with +Y up.
void write_camera_node(Writer& out, const scene::Camera& camera) {
  const scene::CameraFrame frame = scene::camera_frame(camera);
  const Vec3d x = frame.right;
  const Vec3d y = frame.up;
  const Vec3d z = -frame.forward;
  const Vec3d o = camera.position_m;
  const Mat4 matrix{{x.x, y.x, z.x, o.x, x.y, y.y, z.y, o.y, x.z, y.z, z.z, o.z, 0, 0, 0, 1}};
  out.begin_object().member("name", "camera").member("camera", 0);
  write_placement(out, placement_of(matrix).value());
  out.end_object();
}

void write_light_node(Writer& out, const PunctualLight& light, int index) {
  out.begin_object().member("name", light.name);
  write_placement(out, light.placement);
  out.key("extensions").begin_object().key(kLights).begin_object().member("light", index);
  out.end_object().end_object().end_object();
}

// KHR_lights_punctual has candela and lux, and a surface that emits has nits: watts in all three places give
// the same image.
void write_lights(Writer& out, const std::vector<PunctualLight>& lights, Extensions& used) {
  if (lights.empty()) return;
  used.insert(kLights);
  out.key("extensions").begin_object().key(kLights).begin_object().key("lights").begin_array();
  for (const PunctualLight& light : lights) {
    out.begin_object().member("name", light.name).member("type", light.type);
    out.member("color", light.colour).member("intensity", light.intensity).end_object();
  }
  out.end_array().end_object().end_object();
}

struct CameraWriter {
  Writer& out;
  const Document& document;

  // Without zfar nothing is too far away.
  void operator()(const scene::Perspective& kind) const {
    const scene::Camera& camera = document.camera;
    begin(kind.kType);
    out.member("aspectRatio", static_cast<double>(camera.width_px) / camera.height_px);
    out.member("yfov", camera.fov_y_deg * std::numbers::pi / 180).member("znear", document.near_m);
  }
  // xmag and ymag are half extents, and zfar is required.
  void operator()(const scene::Orthographic& kind) const {
    const auto frame = scene::camera_frame(document.camera);
    begin(kind.kType);
    out.member("xmag", frame.half_width).member("ymag", frame.half_height);
    out.member("znear", 0).member("zfar", document.far_m);
  }
  void operator()(const scene::LatitudeLongitude&) const {}  // refused
  void begin(const char* type) const { out.member("type", type).key(type).begin_object(); }
};

void write_camera(Writer& out, const Document& document) {
  out.key("cameras").begin_array().begin_object();
  std::visit(CameraWriter{out, document}, document.camera.projection);
  out.end_object().end_object().end_array();
}

int wrap_code(scene::Wrap wrap) {
  constexpr int kRepeat = 10497;
  constexpr int kClampToEdge = 33071;
  constexpr int kMirroredRepeat = 33648;
  if (wrap == scene::Wrap::Mirror) return kMirroredRepeat;
  return wrap == scene::Wrap::Repeat ? kRepeat : kClampToEdge;
}

// The same filter for the one image that there is, at any distance.
int filter_code(scene::Filter filter) {
  constexpr int kNearest = 9728;
  constexpr int kLinear = 9729;
  return filter == scene::Filter::Nearest ? kNearest : kLinear;
}

void write_textures(Writer& out, const std::vector<Texture>& textures) {
  if (textures.empty()) return;
  out.key("images").begin_array();
  for (const Texture& texture : textures)
    out.begin_object()
        .member("name", texture.name)
        .member("bufferView", texture.view)
        .member("mimeType", "image/png")
        .end_object();
  out.end_array().key("samplers").begin_array();
  for (const Texture& texture : textures)
    out.begin_object()
        .member("magFilter", filter_code(texture.filter))
        .member("minFilter", filter_code(texture.filter))
        .member("wrapS", wrap_code(texture.wrap_u))
        .member("wrapT", wrap_code(texture.wrap_v))
        .end_object();
  out.end_array().key("textures").begin_array();
  for (int i = 0; i < static_cast<int>(textures.size()); ++i)
    out.begin_object().member("sampler", i).member("source", i).end_object();
  out.end_array();
}

void write_extras(Writer& out, const Document& document) {
  out.key("extras").begin_object().key("orbs").begin_object();
  out.member("width", document.camera.width_px).member("height", document.camera.height_px);
  out.key("trace_depth");
  if (document.trace_depth == scene::kUnlimitedDepth)
    out.value("unlimited");
  else
    out.value(document.trace_depth);
  out.end_object().end_object();
}

void write_scene(Writer& out, const Document& document) {
  const int light_count = static_cast<int>(document.lights.size());
  const int camera = static_cast<int>(document.nodes.size()) + light_count;
  out.key("nodes").begin_array();
  for (const Node& node : document.nodes) write_node(out, node);
  for (int i = 0; i < light_count; ++i) write_light_node(out, nth(document.lights, i), i);
  write_camera_node(out, document.camera);
  out.end_array().member("scene", 0).key("scenes").begin_array().begin_object();
  out.member("name", document.name);
  out.key("nodes").begin_array();
  for (int i = 0; i <= camera; ++i) out.value(i);
  out.end_array();
  write_extras(out, document);
  out.end_object().end_array();
}

void write_extension_names(Writer& out, const Extensions& used) {
  if (used.empty()) return;
  out.member("extensionsUsed", std::vector<std::string>(used.begin(), used.end()));
  std::vector<std::string> required;
  std::set_intersection(used.begin(), used.end(), required_extensions().begin(), required_extensions().end(),
                        std::back_inserter(required));
  if (!required.empty()) out.member("extensionsRequired", required);
}

}  // namespace

std::string json_text(const Document& document) {
  Writer out;
  Extensions used;
  out.begin_object().key("asset").begin_object();
  out.member("version", "2.0").member("generator", "orbs").end_object();
  write_scene(out, document);
  write_camera(out, document);
  if (!document.meshes.empty()) {
    out.key("materials").begin_array();
    for (const Material& material : document.materials) write_material(out, material, used);
    out.end_array().key("meshes").begin_array();
    for (const Mesh& mesh : document.meshes) write_mesh(out, mesh);
    out.end_array();
  }
  write_textures(out, document.textures);
  write_buffer(out, document.buffer);
  write_lights(out, document.lights, used);
  write_extension_names(out, used);
  return out.end_object().text();
}

}  // namespace orbs::adapters::gltf
