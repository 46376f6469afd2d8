#include "tracer/surface.h"

#include <algorithm>

namespace orbs::tracer {

namespace {

inline Vec3f interpolated_normal(const TriangleMesh& mesh, const Hit& hit) {
  const auto& corners = mesh.triangles[hit.primitive];
  const float b1 = hit.barycentric.x;
  const float b2 = hit.barycentric.y;
  return mesh.normals[corners[0]] * (1 - b1 - b2) + mesh.normals[corners[1]] * b1 +
         mesh.normals[corners[2]] * b2;
}

// Opposite vertex normals can cancel in between; the face then speaks for them.
Vec3f unit_or(Vec3f normal, Vec3f geometric_normal) {
  const float squared = dot(normal, normal);
  return squared > 0 ? normal / std::sqrt(squared) : geometric_normal;
}

// Rounding off the plane, in half units in the last place of the corners' size: about 6 for the sum of corner
// and edges, and 6 for the differences corner - origin in the next ray's own test. (Error analysis as in
// Physically Based Rendering, 4th ed., 6.8.5; errors along the plane do no harm.)
constexpr float kFaceRounding = 12 * 0x1p-24F;
// The transform of an instance adds 4 for each of the corner and the edges' ends.
constexpr float kInstanceRounding = 20 * 0x1p-24F;

void place_on_instance(
    const Part& part, const Face& face, const TriangleMesh& mesh, const Hit& hit, SurfacePoint& out) {
  const Vec3f p0 = apply_to_point(part.to_world, face.corner);
  const Vec3f e1 = apply_to_direction(part.to_world, face.edge1);
  const Vec3f e2 = apply_to_direction(part.to_world, face.edge2);
  out.position = p0 + e1 * hit.barycentric.x + e2 * hit.barycentric.y;
  out.geometric_normal = normalised(cross(e1, e2));
  const Vec3f normal = face.has_one_normal ? face.shading_normal : interpolated_normal(mesh, hit);
  out.shading_normal = unit_or(apply_to_direction(part.normal_to_world, normal), out.geometric_normal);
  out.position_error = kInstanceRounding * std::max({largest_magnitude(p0), largest_magnitude(p0 + e1),
                                                     largest_magnitude(p0 + e2)});
}

}  // namespace

void prepare_faces(TriangleMesh& mesh) {
  mesh.faces.resize(mesh.triangles.size());
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto& corners = mesh.triangles[i];
    const Vec3f p0 = mesh.positions[corners[0]];
    const Vec3f p1 = mesh.positions[corners[1]];
    const Vec3f p2 = mesh.positions[corners[2]];
    const Vec3f n0 = mesh.normals[corners[0]];
    Face& face = mesh.faces[i];
    face.corner = p0;
    face.edge1 = p1 - p0;
    face.edge2 = p2 - p0;
    face.material = mesh.materials[i];
    face.geometric_normal = unit_or(cross(face.edge1, face.edge2), {});
    face.has_one_normal = n0 == mesh.normals[corners[1]] && n0 == mesh.normals[corners[2]];
    face.shading_normal = unit_or(n0, face.geometric_normal);
    face.size = std::max({largest_magnitude(p0), largest_magnitude(p1), largest_magnitude(p2)});
  }
}

SurfacePoint surface_point(const World& world, const Hit& hit) {
  const Part& part = world.parts[hit.part];
  const TriangleMesh& mesh = world.meshes[part.mesh];
  const Face& face = mesh.faces[hit.primitive];
  SurfacePoint out;
  out.material = part.material_of[static_cast<std::size_t>(face.material)];
  if (part.kind == PartKind::InstancedMesh) {
    place_on_instance(part, face, mesh, hit, out);
    return out;
  }
  out.position = face.corner + face.edge1 * hit.barycentric.x + face.edge2 * hit.barycentric.y;
  out.geometric_normal = face.geometric_normal;
  out.shading_normal = face.has_one_normal ? face.shading_normal
                                           : unit_or(interpolated_normal(mesh, hit), face.geometric_normal);
  out.position_error = kFaceRounding * face.size;
  return out;
}

Vec2f texture_coordinates(const World& world, const Hit& hit) {
  const TriangleMesh& mesh = world.meshes[world.parts[hit.part].mesh];
  const auto& corners = mesh.triangles[hit.primitive];
  const float b1 = hit.barycentric.x;
  const float b2 = hit.barycentric.y;
  const float b0 = 1 - b1 - b2;
  const Vec2f t0 = mesh.uvs[corners[0]];
  const Vec2f t1 = mesh.uvs[corners[1]];
  const Vec2f t2 = mesh.uvs[corners[2]];
  return {b0 * t0.x + b1 * t1.x + b2 * t2.x, b0 * t0.y + b1 * t1.y + b2 * t2.y};
}

Vec3f emitted_radiance(const World& world, const SurfaceMaterial& material, Vec2f uv) {
  if (material.texture < 0) return material.colour;
  return material.colour * lookup(world.textures[static_cast<std::size_t>(material.texture)], uv);
}

}  // namespace orbs::tracer
