#pragma once

#include "json/writer.h"
#include "scene/load/entry.h"
#include "scene/shapes/shape_type.h"

#include <array>

namespace orbs::scene {

/// About the origin.
struct BoxForm {
  static constexpr const char* kType = "box";
  static constexpr const char* kWhat = "a box";
  static constexpr const char* kLevel = "S1";
  Vec3d half_sizes_m{1, 1, 1};
  bool operator==(const BoxForm&) const = default;
};

inline bool is_closed(const BoxForm&) { return true; }

inline void load(ShapeEntry& entry, BoxForm& loaded) {
  const auto sizes = entry.in.numbers("half_sizes", 3, kLength);
  loaded.half_sizes_m = {sizes[0], sizes[1], sizes[2]};
}

inline void write(json::Writer& out, const MaterialList&, const BoxForm& form) {
  out.member("half_sizes", form.half_sizes_m);
}

inline std::optional<LocalBox> bounds(const BoxForm& form) {
  return LocalBox{-form.half_sizes_m, form.half_sizes_m};
}

// Texture coordinates run with the two other axes in their order: those of the faces of x with z and y.
inline std::optional<Mesh> tessellated(const BoxForm& form) {
  constexpr std::array kNormals{Vec3d{1, 0, 0}, Vec3d{0, 1, 0}, Vec3d{0, 0, 1}};
  constexpr std::array kRows{Vec3d{0, 1, 0}, Vec3d{0, 0, 1}, Vec3d{1, 0, 0}};
  Mesh mesh;
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const double side : {-1.0, 1.0}) {
      const auto first = vertex_count(mesh);
      const Vec3d normal = kNormals[axis] * side;
      const Vec3d along = kRows[axis];
      const Vec3d across = cross(normal, along);
      for (const double i : {-1.0, 1.0})
        for (const double j : {-1.0, 1.0}) {
          const Vec3d p = normal + along * i + across * j;
          const double u = axis == 0 ? p.z : p.x;
          const double v = axis == 1 ? p.z : p.y;
          add_vertex(mesh, p * form.half_sizes_m, normal, {(u + 1) / 2, (v + 1) / 2});
        }
      add_grid_triangles(mesh, first, 1, 1);
    }
  return mesh;
}

}  // namespace orbs::scene
