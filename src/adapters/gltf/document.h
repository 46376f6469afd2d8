#pragma once

#include "adapters/gltf/buffer.h"
#include "adapters/gltf/materials.h"
#include "adapters/gltf/placement.h"
#include "scene/scene.h"

#include <optional>
#include <string>
#include <vector>

/// A glTF file as plain data, and its bytes.
namespace orbs::adapters::gltf {

struct TextureInfo {
  int texture = 0;
  int uv_set = 0;
  std::optional<TextureTransform> transform{};
};

struct NormalTexture {
  TextureInfo info{};
  double scale = 1;
};

struct Material {
  std::string name;
  Surface surface{};
  std::optional<TextureInfo> texture{};  // of what shines, or else of the base colour
  std::optional<NormalTexture> normals{};
};

struct Mesh {
  std::string name;
  int positions = 0;  // accessors
  int normals = 0;
  std::optional<int> tangents{};
  std::vector<int> uvs{};  // a set each
  int triangles = 0;
  int material = 0;
};

struct Node {
  std::string name;
  Placement placement{};
  int mesh = 0;
};

/// A light without an area, which shines along its node's -Z (KHR_lights_punctual).
struct PunctualLight {
  std::string name;
  const char* type = "point";
  scene::RgbColour colour{};  // the largest channel is 1
  double intensity = 0;       // candela of a point, lux of light from afar
  Placement placement{};
};

struct Texture {
  std::string name;
  int view = 0;  // that holds its PNG
  scene::Wrap wrap_u = scene::Wrap::Repeat;
  scene::Wrap wrap_v = scene::Wrap::Repeat;
  scene::Filter filter = scene::Filter::Linear;
};

struct Document {
  std::string name;
  scene::Camera camera{};
  double near_m = 0;  // glTF's cameras must have one
  double far_m = 1;   // of an orthographic camera
  int trace_depth = 0;
  Buffer buffer{};
  std::vector<Texture> textures{};
  std::vector<Material> materials{};
  std::vector<Mesh> meshes{};
  std::vector<Node> nodes{};  // without those of the camera and the lights
  std::vector<PunctualLight> lights{};
};

/// The JSON of the file. What glTF has no word for stands in "extras" of the scene, under "orbs": the size of
/// the image and the trace depth, "unlimited" or a number.
std::string json_text(const Document& document);

}  // namespace orbs::adapters::gltf
