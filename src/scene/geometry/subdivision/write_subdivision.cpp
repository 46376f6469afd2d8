#include "scene/geometry/subdivision/write_subdivision.h"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace orbs::scene {

namespace {

using json::Writer;

void write_indices(Writer& out, std::string_view key, const std::vector<std::uint32_t>& indices) {
  out.key(key).numbers(std::vector<double>(indices.begin(), indices.end()));
}

void write_sharp(Writer& out, std::string_view key, const std::vector<SharpPoints>& all) {
  if (all.empty()) return;
  out.key(key).begin_array();
  for (const auto& [points, sharpness] : all) {
    out.begin_object();
    write_indices(out, "points", points);
    if (std::isfinite(sharpness)) out.member("sharpness", sharpness);
    out.end_object();
  }
  out.end_array();
}

}  // namespace

void write_subdivision(Writer& out, const SubdivisionSurface& surface) {
  const ControlCage& cage = surface.cage;
  std::vector<double> numbers;
  for (const Vec3d p : cage.points_m) numbers.insert(numbers.end(), {p.x, p.y, p.z});
  out.begin_object().key("points").numbers(numbers);
  write_indices(out, "faces", cage.face_points);
  if (std::any_of(cage.face_sizes.begin(), cage.face_sizes.end(), [](auto size) { return size != 4; }))
    write_indices(out, "face_sizes", cage.face_sizes);
  write_sharp(out, "creases", cage.creases);
  write_sharp(out, "corners", cage.corners);
  out.member("levels", surface.levels);
  if (surface.displacement) {
    out.key("displacement").begin_object().member("expression", surface.displacement->expression.text);
    out.member("origin", surface.displacement->origin_m).end_object();
  }
  out.end_object();
}

}  // namespace orbs::scene
