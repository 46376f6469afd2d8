#include "adapters/mitsuba/sheets.h"

#include <array>

namespace orbs::adapters::mitsuba {

scene::Mesh sheet_along(Vec3d axis, const scene::Mesh& mesh, const Mat4& place) {
  const Mat4 back = inverse(place).value();  // the loader lets only invertible matrices through
  scene::Mesh sheet;
  sheet.name = mesh.name;
  for (const auto& triangle : mesh.triangles) {
    std::array<Vec3d, 3> corner;
    for (std::size_t i = 0; i < 3; ++i)
      corner[i] = transform_point(place, cast<double>(mesh.positions[triangle[i]]));
    const Vec3d normal = normalised(cross(corner[1] - corner[0], corner[2] - corner[0]));
    const Vec3d u = normalised(axis - normal * dot(axis, normal));
    const Vec3d v = cross(normal, u);
    const auto first = static_cast<std::uint32_t>(sheet.positions.size());
    for (std::size_t i = 0; i < 3; ++i) {
      // Measured from the first corner: far from the origin floats would round the direction away.
      const Vec3d from_first = corner[i] - corner[0];
      sheet.positions.push_back(cast<float>(corner[i]));
      sheet.normals.push_back(
          cast<float>(normalised(transform_normal(back, cast<double>(mesh.normals[triangle[i]])))));
      sheet.tangents.emplace_back();
      sheet.uvs.push_back({static_cast<float>(dot(from_first, u)), static_cast<float>(dot(from_first, v))});
    }
    sheet.triangles.push_back({first, first + 1, first + 2});
  }
  sheet.triangle_materials.assign(sheet.triangles.size(), 0);
  return sheet;
}

}  // namespace orbs::adapters::mitsuba
