#pragma once

#include "json/writer.h"
#include "scene/load/entry.h"
#include "scene/shapes/revolved.h"
#include "scene/shapes/shape_type.h"

namespace orbs::scene {

/// y = height (x^2 + z^2) / radius^2 up to the height.
struct ParaboloidForm {
  static constexpr const char* kType = "paraboloid";
  static constexpr const char* kWhat = "a paraboloid";
  static constexpr const char* kLevel = "S1";
  static constexpr const char* kClosedBy = "\"caps\": true";
  double radius_m = 1;
  double height_m = 1;
  bool has_caps = true;
  bool operator==(const ParaboloidForm&) const = default;
};

inline bool is_closed(const ParaboloidForm& form) { return form.has_caps; }

inline void load(ShapeEntry& entry, ParaboloidForm& loaded) {
  loaded.radius_m = entry.in.number("radius", kLength);
  loaded.height_m = entry.in.number("height", kLength);
  loaded.has_caps = load_caps(entry);
}

inline void write(json::Writer& out, const MaterialList&, const ParaboloidForm& form) {
  out.member("radius", form.radius_m).member("height", form.height_m).member("caps", form.has_caps);
}

inline std::optional<LocalBox> bounds(const ParaboloidForm& form) {
  return about_axis(form.radius_m, 0, form.height_m);
}

inline RevolvedQuadric revolved(const ParaboloidForm& form) {
  return {0, form.radius_m * form.radius_m / form.height_m, 0, 0, form.height_m, form.has_caps};
}

inline std::optional<Mesh> tessellated(const ParaboloidForm& form) {
  std::vector<double> heights;  // of even radii
  for (int i = kShapeBands; i >= 0; --i)
    heights.push_back(form.height_m * i * i / (kShapeBands * kShapeBands));
  return turned(revolved(form), heights);
}

}  // namespace orbs::scene
