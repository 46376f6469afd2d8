#include "golden/read_back.h"

namespace orbs::tests {

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

}  // namespace orbs::tests
