#include "scene/geometry/subdivision/entry.h"

#include "base/error.h"
#include "scene/geometry/subdivision/tessellate_surface.h"
#include "scene/shapes/expression.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include <fmt/format.h>

namespace orbs::scene {

namespace {

using json::ObjectReader;

// Some 700 MB while they are made.
constexpr std::size_t kMostTriangles = std::size_t{1} << 22;

std::vector<std::uint32_t> indices(ObjectReader& in, const std::string& key) {
  // Below the number of a half edge that stands for none.
  constexpr json::Range kIndex{0, 1e9};
  const auto numbers = in.numbers(key, 0, kIndex);
  std::vector<std::uint32_t> out(numbers.size());
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    out[i] = static_cast<std::uint32_t>(numbers[i]);
    if (numbers[i] != static_cast<double>(out[i]))
      in.fail_at(key, i, fmt::format("must be a whole number, is {}", numbers[i]));
  }
  return out;
}

std::vector<Vec3d> load_points(ObjectReader& in) {
  const auto numbers = in.numbers("points", 0, kPlace);
  if (numbers.size() % 3 != 0)
    in.fail("points", fmt::format("must hold groups of 3 numbers, holds {}", numbers.size()));
  std::vector<Vec3d> points;
  for (std::size_t i = 0; i < numbers.size(); i += 3)
    points.push_back({numbers[i], numbers[i + 1], numbers[i + 2]});
  return points;
}

// Without sizes, all faces are quadrilaterals.
std::vector<std::uint32_t> load_face_sizes(ObjectReader& in, std::size_t corners) {
  if (in.has("face_sizes")) return indices(in, "face_sizes");
  if (corners % 4 != 0)
    in.fail("faces", fmt::format("holds {} indices, no multiple of 4: give \"face_sizes\" for faces that are "
                                 "no quadrilaterals",
                                 corners));
  return std::vector<std::uint32_t>(corners / 4, 4);
}

std::vector<SharpPoints> load_sharp(ObjectReader& in, const std::string& key, std::size_t fewest) {
  std::vector<SharpPoints> all;
  for (auto& entry : in.objects_or_none(key)) {
    SharpPoints sharp;
    sharp.points = indices(entry, "points");
    if (sharp.points.size() < fewest)
      entry.fail("points", fmt::format("must be at least {}, there are {}", fewest, sharp.points.size()));
    if (entry.has("sharpness")) sharp.sharpness = entry.number("sharpness", {0, kMostLevels});
    entry.finish();
    all.push_back(std::move(sharp));
  }
  return all;
}

Displacement load_displacement(ObjectReader in) {
  Displacement displacement;
  try {
    displacement.expression = parse_expression(in.text("expression"));
  } catch (const InputError& e) {
    in.fail("expression", e.what());
  }
  displacement.origin_m = in.vec3_or("origin", {}, kPlace);
  in.finish();
  return displacement;
}

SubdivisionSurface load_surface(ObjectReader& in) {
  SubdivisionSurface surface;
  surface.cage.points_m = load_points(in);
  surface.cage.face_points = indices(in, "faces");
  surface.cage.face_sizes = load_face_sizes(in, surface.cage.face_points.size());
  surface.cage.creases = load_sharp(in, "creases", 2);
  surface.cage.corners = load_sharp(in, "corners", 1);
  surface.levels = in.integer("levels", 1, kMostLevels);
  if (in.has("displacement")) surface.displacement = load_displacement(in.object("displacement"));
  in.finish();
  return surface;
}

// Far from zero the vertices are stored relative to an origin, which the matrices of instances add again.
void move_cage(SubdivisionSurface& surface, Vec3d origin_m) {
  for (Vec3d& p : surface.cage.points_m) p = p - origin_m;
  if (surface.displacement) surface.displacement->origin_m = surface.displacement->origin_m - origin_m;
}

}  // namespace

MeshFile load_subdivision(ObjectReader& in, SceneBudget& left) {
  auto entry = in.object("subdivision");
  SubdivisionSurface surface = load_surface(entry);
  const std::size_t triangles = triangle_count(surface);
  if (triangles > kMostTriangles)
    entry.fail("levels",
               fmt::format("{} faces' corners and {} levels make {} triangles, more than {}: take "
                           "fewer levels, each has a quarter of the triangles",
                           surface.cage.face_points.size(), surface.levels, triangles, kMostTriangles));
  spend(entry, "levels", "triangles", triangles, left.triangles);
  MeshFile file;
  try {
    SurfaceMesh made = tessellate(surface);
    place_vertices(made.places_m, file);
    if (!(file.origin_m == Vec3d{})) {
      // Made again, so that a cage that is written about its origin gives the same vertices to the bit.
      move_cage(surface, file.origin_m);
      made = tessellate(surface);
      for (std::size_t i = 0; i < made.places_m.size(); ++i)
        file.mesh.positions[i] = cast<float>(made.places_m[i]);
    }
    for (const Vec3d normal : made.normals) file.mesh.normals.push_back(cast<float>(normal));
    file.mesh.triangles = std::move(made.triangles);
  } catch (const InputError& e) {
    in.fail("subdivision", e.what());
  }
  file.mesh.tangents.resize(file.mesh.positions.size());
  file.mesh.uvs.resize(file.mesh.positions.size());
  file.mesh.subdivision = std::move(surface);
  return file;
}

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
