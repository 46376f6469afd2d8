#include "scene/geometry/uv_frames.h"

#include "base/matrix.h"

namespace orbs::scene {

std::optional<UvFrame> uv_frame(const Mesh& mesh, std::size_t triangle, int uv_set) {
  const auto& uvs = uv_set == 1 ? mesh.second_uvs : mesh.uvs;
  const auto& corners = mesh.triangles[triangle];
  const auto a = corners[0];
  const auto b = corners[1];
  const auto c = corners[2];
  const auto edge = [&](std::uint32_t to) {
    return cast<double>(mesh.positions[to]) - cast<double>(mesh.positions[a]);
  };
  const auto uv = [&](std::uint32_t to) {
    return Vec2d{double{uvs[to].x} - double{uvs[a].x}, double{uvs[to].y} - double{uvs[a].y}};
  };
  const Vec3d e1 = edge(b);
  const Vec3d e2 = edge(c);
  const Vec2d d1 = uv(b);
  const Vec2d d2 = uv(c);
  const double area = d1.x * d2.y - d2.x * d1.y;
  if (area == 0) return std::nullopt;
  const Vec3d sum =
      cast<double>(mesh.normals[a]) + cast<double>(mesh.normals[b]) + cast<double>(mesh.normals[c]);
  const Vec3d normal = length(sum) > 0 ? sum : cross(e1, e2);
  return UvFrame{(e1 * d2.y - e2 * d1.y) * (1 / area), (e2 * d1.x - e1 * d2.x) * (1 / area),
                 normalised(normal)};
}

bool is_mirrored(const UvFrame& frame) { return dot(cross(frame.normal, frame.per_u), frame.per_v) < 0; }

std::optional<Vec3d> tangent_across(const UvFrame& frame, Vec3d normal) {
  const Vec3d across = frame.per_u - normal * dot(normal, frame.per_u);
  const double size = length(across);
  return size > 0 ? std::optional(across / size) : std::nullopt;
}

bool has_square_frames(const Mesh& mesh) {
  // So far off, slopes are wrong by as much, which changes no light by more. Float coordinates give 1e-6.
  constexpr double kMost = 1e-3;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto frame = uv_frame(mesh, i);
    if (frame && length(cross(frame->normal, frame->per_u) - frame->per_v) > kMost * length(frame->per_u))
      return false;
  }
  return true;
}

}  // namespace orbs::scene
