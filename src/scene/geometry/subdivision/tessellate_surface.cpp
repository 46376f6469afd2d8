#include "scene/geometry/subdivision/tessellate_surface.h"

#include "base/error.h"
#include "scene/geometry/subdivision/subdivide.h"
#include "scene/geometry/subdivision/vertex_ring.h"
#include "scene/geometry/triangulate.h"
#include "scene/shapes/expression.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <utility>

#include <fmt/format.h>

namespace orbs::scene {

namespace {

std::string place_text(Vec3d p) { return fmt::format("({:.6g}, {:.6g}, {:.6g})", p.x, p.y, p.z); }

// The half edges that start at a point, counter-clockwise.
std::vector<std::uint32_t> fan_of(const HalfEdges& mesh, std::uint32_t first) {
  std::vector<std::uint32_t> fan;
  auto half = first;
  do {
    fan.push_back(half);
    half = mesh.opposite[mesh.previous(half)];
  } while (half != kNoHalfEdge && half != first);
  return fan;
}

// Turned so that a sharp edge is the first, as VertexRing asks.
std::vector<std::uint32_t> from_sharp_edge(const HalfEdges& mesh, std::vector<std::uint32_t> fan) {
  const auto is_sharp = [&](std::uint32_t half) { return mesh.edge_sharpness[mesh.edge[half]] > 0; };
  const auto sharp = std::find_if(fan.begin(), fan.end(), is_sharp);
  if (sharp != fan.end()) std::rotate(fan.begin(), sharp, fan.end());
  return fan;
}

VertexRing ring_of(const HalfEdges& mesh, const std::vector<std::uint32_t>& fan) {
  VertexRing ring;
  ring.point_m = mesh.points_m[mesh.from[fan.front()]];
  ring.is_corner = mesh.point_sharpness[mesh.from[fan.front()]] > 0;
  for (const auto half : fan) {
    const auto next = mesh.next(half);
    ring.edge_ends_m.push_back(mesh.points_m[mesh.from[next]]);
    ring.opposite_m.push_back(mesh.points_m[mesh.from[mesh.next(next)]]);
    ring.is_sharp.push_back(mesh.edge_sharpness[mesh.edge[half]] > 0);
  }
  const auto last = mesh.previous(fan.back());
  if (mesh.opposite[last] != kNoHalfEdge) return ring;
  ring.edge_ends_m.push_back(mesh.points_m[mesh.from[last]]);
  ring.is_sharp.push_back(true);
  return ring;
}

// The vertices of a surface and what they are made of.
struct Limit {
  SurfaceMesh mesh;
  std::vector<std::uint32_t> vertex_of_half;  // by half edge: where it starts
  std::vector<std::uint32_t>
      first_of_point;  // the first vertex of each point, and at last how many there are
};

Limit limit_surface(const HalfEdges& refined) {
  Limit out;
  out.vertex_of_half.resize(refined.from.size());
  const auto first = first_half_edges(refined);
  for (std::size_t i = 0; i < refined.points_m.size(); ++i) {
    const auto fan = from_sharp_edge(refined, fan_of(refined, first[i]));
    const RingLimit limit = limit_of(ring_of(refined, fan));
    const auto vertex = static_cast<std::uint32_t>(out.mesh.places_m.size());
    out.first_of_point.push_back(vertex);
    for (std::size_t k = 0; k < fan.size(); ++k) out.vertex_of_half[fan[k]] = vertex + limit.sector[k];
    for (const Vec3d normal : limit.normals) {
      if (normal == Vec3d{})
        throw InputError(
            fmt::format("the surface has no normal at {}: points of the cage coincide, or its faces "
                        "fold back on each other",
                        place_text(limit.point_m)));
      out.mesh.places_m.push_back(limit.point_m);
      out.mesh.normals.push_back(normal);
    }
  }
  out.first_of_point.push_back(static_cast<std::uint32_t>(out.mesh.places_m.size()));
  return out;
}

// Where the vertices lie at the end: a quadrilateral that is concave there is cut along its other diagonal.
void cut_quadrilaterals(const HalfEdges& refined, Limit& limit) {
  std::vector<Vec3d> places(4);
  for (std::size_t h = 0; h < refined.from.size(); h += 4) {
    const auto at = [&](std::size_t k) { return limit.vertex_of_half[h + k]; };
    for (std::size_t k = 0; k < 4; ++k) places[k] = limit.mesh.places_m[at(k)];
    for (const auto& [a, b, c] : triangulate(places).triangles)
      limit.mesh.triangles.push_back({at(a), at(b), at(c)});
  }
}

void move_points(const Displacement& displacement, Limit& limit) {
  SurfaceMesh& mesh = limit.mesh;
  std::vector<double> values(displacement.expression.steps.size());
  for (std::size_t i = 0; i + 1 < limit.first_of_point.size(); ++i) {
    const auto first = limit.first_of_point[i];
    const auto end = limit.first_of_point[i + 1];
    Vec3d direction;
    for (auto vertex = first; vertex < end; ++vertex) direction += mesh.normals[vertex];
    const Vec3d p = mesh.places_m[first];
    const Vec3d at = p - displacement.origin_m;
    const double height_m =
        evaluate(displacement.expression, Point<double>{at.x, at.y, at.z}, std::span(values));
    if (!std::isfinite(height_m))
      throw InputError(fmt::format(
          "the displacement '{}' is {} at the limit point {}; it must be finite everywhere on the surface",
          displacement.expression.text, height_m, place_text(at)));
    if (length(direction) < 1e-9)
      throw InputError(
          fmt::format("the faces at the crease point {} fold back on each other: there is no "
                      "direction to displace it in",
                      place_text(p)));
    const Vec3d place = p + normalised(direction) * height_m;
    for (auto vertex = first; vertex < end; ++vertex) mesh.places_m[vertex] = place;
  }
}

void set_triangle_normals(SurfaceMesh& mesh) {
  std::vector<Vec3d> sums(mesh.places_m.size());
  for (const auto& corners : mesh.triangles) {
    const auto at = [&](std::size_t k) { return mesh.places_m[corners[k % 3]]; };
    const Vec3d area = cross(at(1) - at(0), at(2) - at(0));
    if (area == Vec3d{}) continue;
    const Vec3d normal = normalised(area);
    for (std::size_t k = 0; k < 3; ++k)
      sums[corners[k]] += normal * angle_between(at(k + 1) - at(k), at(k + 2) - at(k));
  }
  for (std::size_t i = 0; i < sums.size(); ++i) {
    if (!(length(sums[i]) > 0))
      throw InputError(
          fmt::format("the displaced surface has no normal at {}: its triangles have no area there",
                      place_text(mesh.places_m[i])));
    mesh.normals[i] = normalised(sums[i]);
  }
}

void check_sharpness(const SubdivisionSurface& surface) {
  for (const auto* sharp : {&surface.cage.creases, &surface.cage.corners})
    for (const auto& [points, sharpness] : *sharp)
      if (std::isfinite(sharpness) && sharpness > surface.levels)
        throw InputError(
            fmt::format("a sharpness is {}, must not exceed levels, {}: limit points have a closed "
                        "form only when each step has taken 1 of it",
                        sharpness, surface.levels));
}

}  // namespace

std::size_t triangle_count(const SubdivisionSurface& surface) {
  return surface.cage.face_points.size() << (2 * surface.levels - 1);
}

SurfaceMesh tessellate(const SubdivisionSurface& surface) {
  check_sharpness(surface);
  HalfEdges refined = connect(surface.cage);
  for (int level = 0; level < surface.levels; ++level) refined = subdivide(refined);
  Limit limit = limit_surface(refined);
  if (surface.displacement) move_points(*surface.displacement, limit);
  cut_quadrilaterals(refined, limit);
  if (surface.displacement) set_triangle_normals(limit.mesh);
  return std::move(limit.mesh);
}

}  // namespace orbs::scene
