#include "scene/geometry/crease_normals.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

namespace orbs::scene {

namespace {

struct Face {
  Vec3d normal;                    // unit; zero without area
  std::array<double, 3> angles{};  // at the corners, radians
};

Vec3d unit_or_zero(Vec3d v) { return dot(v, v) > 0 ? normalised(v) : Vec3d{}; }

Face face_of(const Mesh& mesh, const std::array<std::uint32_t, 3>& corners) {
  const auto at = [&](std::size_t k) { return cast<double>(mesh.positions[corners[k % 3]]); };
  Face face;
  face.normal = unit_or_zero(cross(at(1) - at(0), at(2) - at(0)));
  for (std::size_t k = 0; k < 3; ++k) face.angles[k] = angle_between(at(k + 1) - at(k), at(k + 2) - at(k));
  return face;
}

struct Corner {
  std::size_t triangle = 0;
  std::size_t place = 0;  // in the triangle
};

using CornersAt = std::map<std::array<float, 3>, std::vector<Corner>>;

CornersAt corners_by_position(const Mesh& mesh) {
  CornersAt corners;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3f p = mesh.positions[mesh.triangles[i][k]];
      corners[{p.x, p.y, p.z}].push_back({i, k});
    }
  return corners;
}

Vec3f normal_at(const std::vector<Face>& faces,
                const std::vector<Corner>& around,
                const Face& own,
                double least_cosine) {
  Vec3d sum;
  for (const auto& [triangle, place] : around)
    // Faces without area join all others, and take the normal of those that they touch.
    if (own.normal == Vec3d{} || dot(faces[triangle].normal, own.normal) >= least_cosine)
      sum += faces[triangle].normal * faces[triangle].angles[place];
  sum = unit_or_zero(sum);
  return sum == Vec3d{} ? Vec3f{0, 1, 0} : cast<float>(sum);
}

// The vertices of the mesh, one for each normal that their corners have.
class Splitter {
 public:
  explicit Splitter(Mesh& mesh) : mesh_(mesh), has_normal_(mesh.positions.size(), false) {}

  void set(std::uint32_t& corner, Vec3f normal) {
    if (!has_normal_[corner]) {
      has_normal_[corner] = true;
      mesh_.normals[corner] = normal;
      return;
    }
    if (mesh_.normals[corner] == normal) return;
    const auto next = static_cast<std::uint32_t>(mesh_.positions.size());
    const auto [known, is_new] = split_.try_emplace({corner, {normal.x, normal.y, normal.z}}, next);
    if (is_new) {
      const auto position = mesh_.positions[corner];
      const auto tangent = mesh_.tangents[corner];
      const auto uv = mesh_.uvs[corner];
      mesh_.positions.push_back(position);
      mesh_.tangents.push_back(tangent);
      mesh_.uvs.push_back(uv);
      mesh_.normals.push_back(normal);
      has_normal_.push_back(true);
    }
    corner = known->second;
  }

 private:
  Mesh& mesh_;
  std::vector<bool> has_normal_;
  std::map<std::pair<std::uint32_t, std::array<float, 3>>, std::uint32_t> split_;
};

}  // namespace

void compute_normals(Mesh& mesh, double crease_deg, GivenNormals given) {
  // Planes that are turned by the angle itself differ in the last digits of their cosine.
  const double least_cosine = std::cos(crease_deg * std::numbers::pi / 180) - 1e-9;
  std::vector<Face> faces;
  for (const auto& corners : mesh.triangles) faces.push_back(face_of(mesh, corners));
  std::vector<bool> keeps(mesh.positions.size(), false);
  for (std::size_t i = 0; i < keeps.size(); ++i) {
    keeps[i] = given == GivenNormals::Keep && is_direction(mesh.normals[i]);
    if (!keeps[i]) mesh.normals[i] = {0, 1, 0};  // for vertices that no triangle has
  }
  Splitter splitter(mesh);
  for (const auto& [position, around] : corners_by_position(mesh))
    for (const auto& [triangle, place] : around)
      if (std::uint32_t& corner = mesh.triangles[triangle][place]; !keeps[corner])
        splitter.set(corner, normal_at(faces, around, faces[triangle], least_cosine));
}

}  // namespace orbs::scene
