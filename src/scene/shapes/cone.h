#pragma once

#include "json/writer.h"
#include "scene/load/entry.h"
#include "scene/shapes/revolved.h"
#include "scene/shapes/shape_type.h"

#include <algorithm>

namespace orbs::scene {

/// The radius falls evenly from `radius` at y = 0 to `top_radius` at the height.
struct ConeForm {
  static constexpr const char* kType = "cone";
  static constexpr const char* kWhat = "a cone";
  static constexpr const char* kLevel = "S1";
  static constexpr const char* kClosedBy = "\"caps\": true";
  double radius_m = 1;
  double top_radius_m = 0;
  double height_m = 1;
  bool has_caps = true;
  bool operator==(const ConeForm&) const = default;
};

inline bool is_closed(const ConeForm& form) { return form.has_caps; }

inline void load(ShapeEntry& entry, ConeForm& loaded) {
  loaded.radius_m = entry.in.number("radius", {0, kFarthest_m});
  loaded.top_radius_m = entry.in.number_or("top_radius", 0, {0, kFarthest_m});
  loaded.height_m = entry.in.number("height", kLength);
  loaded.has_caps = load_caps(entry);
  if (loaded.radius_m == 0 && loaded.top_radius_m == 0)
    entry.in.fail("radius", "must be above 0 where top_radius is 0: the cone has no width");
}

inline void write(json::Writer& out, const MaterialList&, const ConeForm& form) {
  out.member("radius", form.radius_m).member("top_radius", form.top_radius_m);
  out.member("height", form.height_m).member("caps", form.has_caps);
}

inline std::optional<LocalBox> bounds(const ConeForm& form) {
  return about_axis(std::max(form.radius_m, form.top_radius_m), 0, form.height_m);
}

inline RevolvedQuadric revolved(const ConeForm& form) {
  // (r + s y)^2; a cone that ends in its apex has no second nappe between 0 and its height.
  const double slope = (form.top_radius_m - form.radius_m) / form.height_m;
  return {form.radius_m * form.radius_m,
          2 * form.radius_m * slope,
          slope * slope,
          0,
          form.height_m,
          form.has_caps};
}

inline std::optional<Mesh> tessellated(const ConeForm& form) { return turned(revolved(form), 1); }

}  // namespace orbs::scene
