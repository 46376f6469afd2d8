#include "base/files.h"
#include "base/text.h"
#include "golden/read_back.h"
#include "golden/xml.h"

#include <cstdint>
#include <cstring>
#include <numbers>
#include <stdexcept>

#include <fmt/format.h>

namespace orbs::tests {

namespace {

std::vector<double> numbers_of(const std::string& text) {
  std::vector<double> out;
  for (const std::string& word : split(text, ' '))
    if (!word.empty()) out.push_back(to_number(word).value());
  return out;
}

Vec3d vec3(const std::string& text) {
  const auto n = numbers_of(text);
  if (n.size() != 3) throw std::runtime_error("three numbers expected: " + text);
  return {n[0], n[1], n[2]};
}

Mat4 matrix_of(const Element& e) {
  Mat4 m;
  const auto n = numbers_of(e.at("matrix"));
  if (n.size() != 16) throw std::runtime_error("16 numbers expected");
  std::copy(n.begin(), n.end(), m.m.begin());
  return m;
}

const Element& child(const Element& e, const std::string& tag) {
  const Element* found = e.kind(tag);
  if (found == nullptr) throw std::runtime_error(e.name + " has no " + tag);
  return *found;
}

double number(const Element& e, const std::string& tag) { return to_number(child(e, tag).at("val")).value(); }

// A mesh as its reader takes it: a header of 24 bytes, then arrays without gaps.
class VsgfReader {
 public:
  explicit VsgfReader(std::string bytes) : bytes_(std::move(bytes)) {}

  scene::Mesh read() {
    if (next<std::uint64_t>() != bytes_.size()) throw std::runtime_error("size of a VSGF");
    const auto vertices = next<std::uint32_t>();
    const auto indices = next<std::uint32_t>();
    next<std::uint32_t>();  // materials
    if (next<std::uint32_t>() != 1) throw std::runtime_error("flags of a VSGF");
    scene::Mesh mesh;
    mesh.positions = vectors(vertices);
    mesh.normals = vectors(vertices);
    mesh.tangents = vectors(vertices);
    for (std::uint32_t i = 0; i < vertices; ++i) {
      const auto u = next<float>();
      mesh.uvs.push_back({u, next<float>()});
    }
    for (std::uint32_t i = 0; i < indices / 3; ++i) {
      auto& triangle = mesh.triangles.emplace_back();
      for (auto& corner : triangle) corner = next<std::uint32_t>();
    }
    for (std::uint32_t i = 0; i < indices / 3; ++i)
      mesh.triangle_materials.push_back(static_cast<int>(next<std::uint32_t>()));
    if (at_ != bytes_.size()) throw std::runtime_error("bytes behind a VSGF");
    return mesh;
  }

 private:
  template <typename Number>
  Number next() {
    Number value;
    std::memcpy(&value, bytes_.substr(at_, sizeof value).data(), sizeof value);
    at_ += sizeof value;
    return value;
  }
  std::vector<Vec3f> vectors(std::uint32_t count) {
    std::vector<Vec3f> out;
    for (std::uint32_t i = 0; i < count; ++i) {
      const auto x = next<float>();
      const auto y = next<float>();
      out.push_back({x, y, next<float>()});
      next<float>();
    }
    return out;
  }

  std::string bytes_;
  std::size_t at_ = 0;
};

class HydraReader {
 public:
  HydraReader(const Element& root, std::filesystem::path folder) : root_(root), folder_(std::move(folder)) {
    camera();
    const Element& in_scene = child(child(root_, "scenes"), "scene");
    if (const Element* lists = in_scene.kind("remap_lists")) remap_lists(*lists);
    for (const Element& e : in_scene.children) {
      if (e.name == "instance") instance(e);
      if (e.name == "instance_light") light(e);
    }
  }
  ReadScene scene;

 private:
  static std::size_t id(const Element& e, const char* key) {
    return static_cast<std::size_t>(to_number(e.at(key)).value());
  }
  const Element& entry(const char* library, std::size_t position) const {
    return child(root_, library).children.at(position);
  }

  void camera() {
    const Element& camera = entry("cam_lib", 0);
    scene.eye = vec3(child(camera, "position").at("val"));
    scene.target = vec3(child(camera, "look_at").at("val"));
    scene.up = vec3(child(camera, "up").at("val"));
    scene.fov_y_deg = number(camera, "fov");
    const Element& settings = entry("render_lib", 0);
    scene.width_px = static_cast<int>(number(settings, "width"));
    scene.height_px = static_cast<int>(number(settings, "height"));
    scene.trace_depth = static_cast<int>(number(settings, "trace_depth"));
  }
  void remap_lists(const Element& lists) {
    for (const Element& e : lists.children) {
      const auto n = numbers_of(e.at("val"));
      if (n.size() != id(e, "size")) throw std::runtime_error("size of a remap list");
      auto& list = lists_.emplace_back();
      for (std::size_t i = 0; i < n.size(); i += 2) {
        if (i > 0 && n[i] <= n[i - 2]) throw std::runtime_error("a remap list that is not sorted");
        list[static_cast<std::size_t>(n[i])] = static_cast<std::size_t>(n[i + 1]);
      }
      if (list.rbegin()->first + 1 != child(root_, "materials_lib").children.size())
        throw std::runtime_error("a remap list that is not closed");
    }
  }

  // A triangle with the material that the instance shows, seen by its texture.
  void instance(const Element& e) {
    const Mat4 place = matrix_of(e);
    const scene::Mesh mesh =
        VsgfReader(read_file(folder_ / entry("geometry_lib", id(e, "mesh_id")).at("loc"))).read();
    const double list = to_number(e.at("rmap_id")).value();
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
      auto material = static_cast<std::size_t>(mesh.triangle_materials[i]);
      if (list >= 0) {
        const auto& pairs = lists_.at(static_cast<std::size_t>(list));
        if (const auto found = pairs.find(material); found != pairs.end()) material = found->second;
      }
      const Element& model = entry("materials_lib", material);
      if (model.attributes.contains("light_id") != e.attributes.contains("linst_id"))
        throw std::runtime_error("a mesh of a light that does not name it");
      if (model.attributes.contains("light_id")) {
        light_mesh(e, mesh, place);
        return;
      }
      triangle(mesh, i, model, place, fmt::format("material{}", material));
    }
  }

  void triangle(const scene::Mesh& mesh,
                std::size_t i,
                const Element& model,
                const Mat4& place,
                const std::string& name) {
    const Element* colour = model.kind("reflectance");
    if (const Element* emission = model.kind("emission")) {
      colour = emission->kind("color");
      scene.emission[name] = vec3(colour->at("val"));
    }
    const Element* texture = colour == nullptr ? nullptr : colour->kind("texture");
    const Mat4 of_texture = texture == nullptr ? Mat4{} : matrix_of(*texture);
    scene::Mesh one;
    for (const auto corner : mesh.triangles[i]) {
      const Vec2f uv = mesh.uvs[corner];
      one.positions.push_back(mesh.positions[corner]);
      one.normals.push_back(mesh.normals[corner]);
      const Vec3d turned = transform_point(of_texture, {double{uv.x}, double{uv.y}, 0});
      one.uvs.push_back({static_cast<float>(turned.x), static_cast<float>(turned.y)});
    }
    one.triangles = {{0, 1, 2}};
    add_mesh(scene.materials[name], one, place, false);
  }

  // The mesh of a light covers what the light does.
  void light_mesh(const Element& e, const scene::Mesh& mesh, const Mat4& place) {
    Moments moments;
    add_mesh(moments, mesh, place, false);
    mesh_areas_m2_[id(e, "linst_id")] = moments.area_m2;
  }

  void light(const Element& e) {
    const Element& light = entry("lights_lib", id(e, "light_id"));
    const Element& intensity = child(light, "intensity");
    const Vec3d radiance = vec3(child(intensity, "color").at("val")) * number(intensity, "multiplier");
    if (light.at("type") == "sky") {
      scene.environment = radiance;
      return;
    }
    const Mat4 m = matrix_of(e);
    const Element& size = child(light, "size");
    const double x = length(transform_direction(m, {1, 0, 0}));
    const double z = length(transform_direction(m, {0, 0, 1}));
    ReadLight read;
    read.radiance = radiance;
    read.centre = transform_point(m, {});
    if (light.at("shape") == "rect") {
      read.area_m2 =
          4 * x * to_number(size.at("half_length")).value() * z * to_number(size.at("half_width")).value();
    } else {
      const double r = to_number(size.at("radius")).value();
      const bool is_disk = light.at("shape") == "disk";
      read.area_m2 = (is_disk ? 1 : 4) * std::numbers::pi * r * r * x * (is_disk ? z : x);
    }
    if (light.at("shape") != "sphere") read.facing = normalised(transform_direction(m, {0, -1, 0}));
    const double area_of_mesh_m2 = mesh_areas_m2_.at(id(e, "id"));
    if (std::abs(area_of_mesh_m2 / read.area_m2 - 1) > 2e-3) throw std::runtime_error("the mesh of a light");
    scene.lights.push_back(read);
  }

  const Element& root_;
  std::filesystem::path folder_;
  std::vector<std::map<std::size_t, std::size_t>> lists_;
  std::map<std::size_t, double> mesh_areas_m2_;
};

}  // namespace

ReadScene read_hydra(const std::filesystem::path& file) {
  return HydraReader(read_xml(read_file(file)), file.parent_path()).scene;
}

}  // namespace orbs::tests
