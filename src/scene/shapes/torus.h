#pragma once

#include "json/writer.h"
#include "scene/load/entry.h"
#include "scene/shapes/expression.h"
#include "scene/shapes/implicit.h"
#include "scene/shapes/revolved.h"
#include "scene/shapes/shape_type.h"

#include <cmath>

#include <fmt/format.h>

namespace orbs::scene {

/// The ring lies in the xz plane.
struct TorusForm {
  static constexpr const char* kType = "torus";
  static constexpr const char* kWhat = "a torus";
  static constexpr const char* kLevel = "S2";
  double major_radius_m = 1;
  double minor_radius_m = 0.25;
  bool operator==(const TorusForm&) const = default;
};

inline bool is_closed(const TorusForm&) { return true; }

inline void load(ShapeEntry& entry, TorusForm& loaded) {
  loaded.major_radius_m = entry.in.number("major_radius", kLength);
  loaded.minor_radius_m = entry.in.number("minor_radius", kLength);
  if (loaded.minor_radius_m >= loaded.major_radius_m)
    entry.in.fail("minor_radius",
                  fmt::format("must be below the major radius, {}, is {}: the tube would cut itself",
                              loaded.major_radius_m, loaded.minor_radius_m));
}

inline void write(json::Writer& out, const MaterialList&, const TorusForm& form) {
  out.member("major_radius", form.major_radius_m).member("minor_radius", form.minor_radius_m);
}

inline std::optional<LocalBox> bounds(const TorusForm& form) {
  return about_axis(form.major_radius_m + form.minor_radius_m, -form.minor_radius_m, form.minor_radius_m);
}

inline ImplicitForm implicit(const TorusForm& form) {
  // Nearly the distance, so that enclosures are tight: the quartic's are several times as wide.
  constexpr double kRoom = 1 + 1e-6;  // so that the surface does not touch the box
  const double reach = kRoom * (form.major_radius_m + form.minor_radius_m);
  const double height = kRoom * form.minor_radius_m;
  return {parse_expression(
              fmt::format("(sqrt(x^2 + z^2) - {})^2 + y^2 - {}^2", form.major_radius_m, form.minor_radius_m)),
          {-reach, -height, -reach},
          {reach, height, reach},
          true};
}

inline std::optional<Mesh> tessellated(const TorusForm& form) {
  Mesh mesh;
  for (int i = 0; i <= kShapeSegments; ++i)
    for (int j = 0; j <= kShapeSegments; ++j) {
      const double ring = turn_rad(i % kShapeSegments);
      const double tube = turn_rad(j % kShapeSegments);
      const Vec3d out{std::sin(ring), 0, std::cos(ring)};
      const Vec3d normal = out * std::cos(tube) + Vec3d{0, std::sin(tube), 0};
      add_vertex(mesh, out * form.major_radius_m + normal * form.minor_radius_m, normal,
                 {double(i) / kShapeSegments, double(j) / kShapeSegments});
    }
  add_grid_triangles(mesh, 0, kShapeSegments, kShapeSegments);
  return mesh;
}

}  // namespace orbs::scene
