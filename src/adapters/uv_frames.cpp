#include "adapters/uv_frames.h"

#include "base/matrix.h"

namespace orbs::adapters {

std::optional<UvFrame> uv_frame(const scene::Mesh& mesh, std::size_t triangle) {
  const auto& corners = mesh.triangles[triangle];
  const auto a = corners[0];
  const auto b = corners[1];
  const auto c = corners[2];
  const auto edge = [&](std::uint32_t to) {
    return cast<double>(mesh.positions[to]) - cast<double>(mesh.positions[a]);
  };
  const auto uv = [&](std::uint32_t to) {
    return Vec2d{double{mesh.uvs[to].x} - double{mesh.uvs[a].x},
                 double{mesh.uvs[to].y} - double{mesh.uvs[a].y}};
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

bool has_square_frames(const scene::Mesh& mesh) {
  // So far off, slopes are wrong by as much, which changes no light by more. Float coordinates give 1e-6.
  constexpr double kMost = 1e-3;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto frame = uv_frame(mesh, i);
    if (frame && length(cross(frame->normal, frame->per_u) - frame->per_v) > kMost * length(frame->per_u))
      return false;
  }
  return true;
}

}  // namespace orbs::adapters
