#include "golden/read_back.h"

#include <iterator>

namespace orbs::tests {

double value_at(const ReadSpectrum& spectrum, double wavelength_nm) {
  if (spectrum.size() == 1) return spectrum.begin()->second;
  const auto above = spectrum.lower_bound(wavelength_nm);
  if (above == spectrum.end()) return 0;
  if (above->first == wavelength_nm) return above->second;
  if (above == spectrum.begin()) return 0;
  const auto below = std::prev(above);
  const double share = (wavelength_nm - below->first) / (above->first - below->first);
  return below->second + share * (above->second - below->second);
}

std::vector<Vec3d> directions_of_u(const scene::Mesh& mesh, const Mat4& place) {
  std::vector<Vec3d> out;
  for (const auto& t : mesh.triangles) {
    const auto edge = [&](std::size_t i) {
      return transform_direction(place, cast<double>(mesh.positions[t[i]] - mesh.positions[t[0]]));
    };
    const auto uv = [&](std::size_t i) {
      return Vec2d{double{mesh.uvs[t[i]].x} - double{mesh.uvs[t[0]].x},
                   double{mesh.uvs[t[i]].y} - double{mesh.uvs[t[0]].y}};
    };
    // The two edges as sums of dp/du and dp/dv, solved for dp/du.
    const double determinant = uv(1).x * uv(2).y - uv(1).y * uv(2).x;
    out.push_back(normalised((edge(1) * uv(2).y - edge(2) * uv(1).y) / determinant));
  }
  return out;
}

void add_mesh(Moments& moments, const scene::Mesh& mesh, const Mat4& place, bool v_from_top) {
  const Mat4 back = inverse(place).value();
  for (const auto& triangle : mesh.triangles) {
    Vec3d p[3];
    Vec3d centre;
    Vec3d normal;
    Vec2d uv;
    for (std::size_t i = 0; i < 3; ++i) {
      p[i] = transform_point(place, cast<double>(mesh.positions[triangle[i]]));
      centre += p[i] / 3.0;
      normal += normalised(transform_normal(back, cast<double>(mesh.normals[triangle[i]])));
      const Vec2f given = mesh.uvs[triangle[i]];
      uv.x += double{given.x} / 3;
      uv.y += (v_from_top ? 1 - double{given.y} : double{given.y}) / 3;
    }
    const double area = length(cross(p[1] - p[0], p[2] - p[0])) / 2;
    moments.area_m2 += area;
    moments.centre += centre * area;
    moments.normal += normal * area;
    moments.uv = {moments.uv.x + uv.x * area, moments.uv.y + uv.y * area};
  }
}

std::map<int, Moments> moments_of_materials(const scene::Scene& scene, std::optional<Vec2f> untextured_uv) {
  std::map<int, Moments> out;
  for (const scene::Instance& instance : scene.instances) {
    const scene::Mesh& mesh = scene.meshes[static_cast<std::size_t>(instance.mesh)];
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
      const int material = scene::remapped(instance, mesh.triangle_materials[i]);
      const auto& use = scene::texture_of(scene.materials[static_cast<std::size_t>(material)].model);
      scene::Mesh one;
      for (const auto corner : mesh.triangles[i]) {
        one.positions.push_back(mesh.positions[corner]);
        one.normals.push_back(mesh.normals[corner]);
        const Vec2f uv = use || !untextured_uv ? mesh.uvs[corner] : *untextured_uv;
        const Mat4 m = use ? use->matrix : Mat4{};
        one.uvs.push_back({static_cast<float>(m(0, 0) * uv.x + m(0, 1) * uv.y + m(0, 3)),
                           static_cast<float>(m(1, 0) * uv.x + m(1, 1) * uv.y + m(1, 3))});
      }
      one.triangles = {{0, 1, 2}};
      add_mesh(out[material], one, instance.matrix, false);
    }
  }
  return out;
}

}  // namespace orbs::tests
