#include "base/files.h"
#include "base/text.h"
#include "golden/read_back.h"
#include "golden/xml.h"
#include "scene/geometry/ply.h"

#include <numbers>
#include <stdexcept>

namespace orbs::tests {

namespace {

std::vector<double> numbers(std::string text) {
  for (char& c : text)
    if (c == ',') c = ' ';
  std::vector<double> out;
  for (const std::string& word : split(text, ' '))
    if (!word.empty()) out.push_back(to_number(word).value());
  return out;
}

Vec3d vec3(const std::string& text) {
  const auto n = numbers(text);
  if (n.size() != 3) throw std::runtime_error("three numbers expected: " + text);
  return {n[0], n[1], n[2]};
}

Mat4 place_of(const Element& shape) {
  Mat4 m;
  if (const Element* transform = shape.named("to_world")) {
    const auto n = numbers(transform->children.at(0).at("value"));
    if (n.size() != 16) throw std::runtime_error("16 numbers expected");
    std::copy(n.begin(), n.end(), m.m.begin());
  }
  return m;
}

ReadSpectrum spectrum_of(const Element& e, double factor = 1) {
  ReadSpectrum out;
  if (const auto& text = e.at("value"); text.find(':') == std::string::npos) {
    out[0] = factor * to_number(text).value();
  } else {
    for (const std::string& pair : split(text, ',')) {
      const auto parts = split(trim(pair), ':');
      out[to_number(parts.at(0)).value()] = factor * to_number(parts.at(1)).value();
    }
  }
  return out;
}

// Lists in emitters are divided by the first number, then seen by the printed ybar, which sums to the second.
ReadSpectrum emitted(const Element& e) {
  if (e.at("value").find(':') == std::string::npos) throw std::runtime_error("a multiple of D65");
  return spectrum_of(e, 106.856917 / 106.7502593994140625);
}

void read_radiance(const Element& emitter, scene::RgbColour& radiance, ReadSpectrum& spectrum) {
  const Element& e = *emitter.named("radiance");
  if (e.name == "spectrum")
    spectrum = emitted(e);
  else
    radiance = vec3(e.at("value"));
}

// The parameters of a bsdf, those of the one within where it is two-sided.
void read_bsdf(const Element& e, ReadSurface& surface) {
  if (e.at("type") == "twosided") {
    surface.words["two-sided"] = "true";
    return read_bsdf(e.children.at(0), surface);
  }
  surface.type = e.at("type");
  for (const Element& child : e.children)
    if (child.name == "spectrum")
      surface.spectra[child.at("name")] = spectrum_of(child);
    else if (child.name != "texture")
      surface.words[child.at("name")] = child.at("value");
}

ReadLight light_of(const Element& shape) {
  ReadLight light;
  read_radiance(*shape.kind("emitter"), light.radiance, light.spectrum);
  const Element& reflectance = *shape.kind("bsdf")->named("reflectance");
  if (reflectance.name == "spectrum") light.reflectance = spectrum_of(reflectance);
  if (shape.at("type") == "sphere") {
    const double r = shape.number("radius");
    const Element& c = *shape.named("center");
    light.centre = {to_number(c.at("x")).value(), to_number(c.at("y")).value(), to_number(c.at("z")).value()};
    light.area_m2 = 4 * std::numbers::pi * r * r;
    return light;
  }
  // Both lie in XY and face +Z; the square has sides of 2, the disk a radius of 1.
  const Mat4 m = place_of(shape);
  light.centre = transform_point(m, {});
  light.facing = normalised(transform_normal(inverse(m).value(), {0, 0, 1}));
  light.area_m2 = length(cross(transform_direction(m, {1, 0, 0}), transform_direction(m, {0, 1, 0}))) *
                  (shape.at("type") == "rectangle" ? 4 : std::numbers::pi);
  return light;
}

class SceneReader {
 public:
  SceneReader(const Element& root, std::filesystem::path folder) : folder_(std::move(folder)) {
    for (const Element& e : root.children) add(e);
  }
  ReadScene scene;

 private:
  void add(const Element& e) {
    if (e.name == "sensor") return camera(e);
    if (e.name == "integrator") {
      integrator(e);
    } else if (e.name == "emitter") {
      read_radiance(e, scene.environment, scene.environment_spectrum);
    } else if (e.name == "bsdf") {
      read_bsdf(e, scene.surfaces[e.at("id")]);
    } else if (e.name == "shape") {
      shape(e);
    } else if (e.name != "default") {
      throw std::runtime_error("unknown element " + e.name);
    }
  }
  void integrator(const Element& e) {
    scene.has_stokes = e.at("type") == "stokes";
    const Element& path = scene.has_stokes ? e.children.at(0) : e;
    const int segments = static_cast<int>(path.number("max_depth"));  // counts the emitter's vertex
    scene.trace_depth = segments < 0 ? scene::kUnlimitedDepth : segments - 1;
    // Without roulette a path between mirrors has no end.
    if (scene.trace_depth == scene::kUnlimitedDepth && path.number("rr_depth") > 100)
      throw std::runtime_error("no roulette");
  }
  void camera(const Element& e) {
    if (e.value("fov_axis") != "y") throw std::runtime_error("fov_axis");
    const Element& look = e.named("to_world")->children.at(0);
    scene.eye = vec3(look.at("origin"));
    scene.target = vec3(look.at("target"));
    scene.up = vec3(look.at("up"));
    scene.fov_y_deg = e.number("fov");
    scene.width_px = static_cast<int>(e.kind("film")->number("width"));
    scene.height_px = static_cast<int>(e.kind("film")->number("height"));
  }
  void shape(const Element& e) {
    const std::string& type = e.at("type");
    if (type == "shapegroup") {
      groups_.emplace(e.at("id"), e.children.at(0));
    } else if (type == "instance") {
      mesh(groups_.at(e.kind("ref")->at("id")), place_of(e));
    } else if (type == "ply") {
      mesh(e, place_of(e));
    } else {
      scene.lights.push_back(light_of(e));
    }
  }
  void mesh(const Element& e, const Mat4& place) {
    scene::Mesh mesh = scene::read_ply(folder_ / e.value("filename")).mesh;
    const std::string& material = e.kind("ref")->at("id");
    const Element* emitter = e.kind("emitter");
    if (emitter != nullptr) {
      if (e.value("face_normals") != "true") throw std::runtime_error("an emitter with vertex normals");
      ReadSpectrum ignored;
      read_radiance(*emitter, scene.emission[material], ignored);
      take_normals_of_faces(mesh, determinant3(place) < 0 ? -1.0F : 1.0F);
    }
    auto& directions = scene.u_directions[material];
    for (const Vec3d direction : directions_of_u(mesh, place)) directions.push_back(direction);
    add_mesh(scene.materials[material], mesh, place, emitter == nullptr);
  }
  // Mitsuba forms them from the corners in the world, where a mirroring matrix has turned them.
  static void take_normals_of_faces(scene::Mesh& mesh, float sign) {
    scene::Mesh faces;
    for (const auto& t : mesh.triangles) {
      const auto first = static_cast<std::uint32_t>(faces.positions.size());
      const Vec3f normal =
          cross(mesh.positions[t[1]] - mesh.positions[t[0]], mesh.positions[t[2]] - mesh.positions[t[0]]);
      for (const auto corner : t) {
        faces.positions.push_back(mesh.positions[corner]);
        faces.normals.push_back(normal * sign);
        faces.uvs.push_back(mesh.uvs[corner]);
      }
      faces.triangles.push_back({first, first + 1, first + 2});
    }
    mesh = std::move(faces);
  }

  std::filesystem::path folder_;
  std::map<std::string, Element> groups_;
};

}  // namespace

ReadScene read_mitsuba(const std::filesystem::path& file) {
  return SceneReader(read_xml(read_file(file)), file.parent_path()).scene;
}

}  // namespace orbs::tests
