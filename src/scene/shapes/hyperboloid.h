#pragma once

#include "json/writer.h"
#include "scene/load/entry.h"
#include "scene/shapes/revolved.h"
#include "scene/shapes/shape_type.h"

#include <fmt/format.h>

namespace orbs::scene {

/// Of one sheet: `radius` at y = 0 and at the height, `waist_radius` half way.
struct HyperboloidForm {
  static constexpr const char* kType = "hyperboloid";
  static constexpr const char* kWhat = "a hyperboloid";
  static constexpr const char* kLevel = "S1";
  static constexpr const char* kClosedBy = "\"caps\": true";
  double radius_m = 1;
  double waist_radius_m = 0.5;
  double height_m = 1;
  bool has_caps = true;
  bool operator==(const HyperboloidForm&) const = default;
};

inline bool is_closed(const HyperboloidForm& form) { return form.has_caps; }

inline void load(ShapeEntry& entry, HyperboloidForm& loaded) {
  loaded.radius_m = entry.in.number("radius", kLength);
  loaded.waist_radius_m = entry.in.number("waist_radius", {0, kFarthest_m});
  loaded.height_m = entry.in.number("height", kLength);
  loaded.has_caps = load_caps(entry);
  if (loaded.waist_radius_m >= loaded.radius_m)
    entry.in.fail("waist_radius", fmt::format("must be below the radius at the ends, {}, is {}",
                                              loaded.radius_m, loaded.waist_radius_m));
}

inline void write(json::Writer& out, const MaterialList&, const HyperboloidForm& form) {
  out.member("radius", form.radius_m).member("waist_radius", form.waist_radius_m);
  out.member("height", form.height_m).member("caps", form.has_caps);
}

inline std::optional<LocalBox> bounds(const HyperboloidForm& form) {
  return about_axis(form.radius_m, 0, form.height_m);
}

inline RevolvedQuadric revolved(const HyperboloidForm& form) {
  // waist^2 + (radius^2 - waist^2) (2 y / height - 1)^2
  const double excess = form.radius_m * form.radius_m - form.waist_radius_m * form.waist_radius_m;
  const double per_height = 2 / form.height_m;
  return {form.radius_m * form.radius_m,
          -2 * excess * per_height,
          excess * per_height * per_height,
          0,
          form.height_m,
          form.has_caps};
}

inline std::optional<Mesh> tessellated(const HyperboloidForm& form) {
  return turned(revolved(form), kShapeBands);
}

}  // namespace orbs::scene
