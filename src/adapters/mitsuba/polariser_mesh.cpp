#include "adapters/mitsuba/polariser_mesh.h"

#include <array>

namespace orbs::adapters::mitsuba {

scene::Mesh polariser_mesh(Vec3d axis, const scene::Mesh& mesh, const Mat4& place) {
  const Mat4 back = inverse(place).value();  // the loader lets only invertible matrices through
  scene::Mesh flat;
  flat.name = mesh.name;
  for (const auto& triangle : mesh.triangles) {
    std::array<Vec3d, 3> corner;
    for (std::size_t i = 0; i < 3; ++i)
      corner[i] = transform_point(place, cast<double>(mesh.positions[triangle[i]]));
    const Vec3d normal = normalised(cross(corner[1] - corner[0], corner[2] - corner[0]));
    const Vec3d u = normalised(axis - normal * dot(axis, normal));
    const Vec3d v = cross(normal, u);
    const auto first = static_cast<std::uint32_t>(flat.positions.size());
    for (std::size_t i = 0; i < 3; ++i) {
      // Distances are measured from the first corner: far from the origin the direction would be lost to
      // rounding of floats.
      const Vec3d from_first = corner[i] - corner[0];
      flat.positions.push_back(cast<float>(corner[i]));
      flat.normals.push_back(
          cast<float>(normalised(transform_normal(back, cast<double>(mesh.normals[triangle[i]])))));
      flat.tangents.emplace_back();
      flat.uvs.push_back({static_cast<float>(dot(from_first, u)), static_cast<float>(dot(from_first, v))});
    }
    flat.triangles.push_back({first, first + 1, first + 2});
  }
  flat.triangle_materials.assign(flat.triangles.size(), 0);
  return flat;
}

}  // namespace orbs::adapters::mitsuba
