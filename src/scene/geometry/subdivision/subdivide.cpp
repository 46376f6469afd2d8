#include "scene/geometry/subdivision/subdivide.h"

#include <algorithm>

namespace orbs::scene {

namespace {

double after_a_step(double sharpness) { return std::max(0.0, sharpness - 1); }

// The edges at a point that are sharp, and the sum of the points at their other ends.
struct SharpEdges {
  int count = 0;
  Vec3d sum_m;

  void add(Vec3d end_m) {
    ++count;
    sum_m += end_m;
  }
};

// What surrounds a point.
struct Surroundings {
  double valence = 0;  // of faces; within a surface there are as many edges
  Vec3d edge_ends_m;   // their sum
  Vec3d face_points_m;
  SharpEdges before, after;  // the step
  double ending = 0;         // the sum of the sharpnesses that end in this step
  int ending_count = 0;

  void end(double sharpness) {
    if (sharpness <= 0 || after_a_step(sharpness) > 0) return;
    ending += sharpness;
    ++ending_count;
  }
};

enum class Rule { Smooth, Crease, Corner };

// A dart, where one crease ends, moves like a smooth point.
Rule rule_at(bool is_corner, const SharpEdges& edges) {
  if (is_corner || edges.count > 2) return Rule::Corner;
  return edges.count == 2 ? Rule::Crease : Rule::Smooth;
}

Vec3d moved_by(Rule rule, Vec3d point_m, const Surroundings& around, const SharpEdges& edges) {
  if (rule == Rule::Corner) return point_m;
  if (rule == Rule::Crease) return (6 * point_m + edges.sum_m) / 8;
  const double n = around.valence;
  return ((n - 2) * point_m + (around.edge_ends_m + around.face_points_m) / n) / n;
}

std::vector<Vec3d> face_points(const HalfEdges& mesh) {
  std::vector<Vec3d> points(mesh.face_count());
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (auto h = mesh.first_of_face[i]; h < mesh.first_of_face[i + 1]; ++h)
      points[i] += mesh.points_m[mesh.from[h]];
    points[i] = points[i] / static_cast<double>(mesh.first_of_face[i + 1] - mesh.first_of_face[i]);
  }
  return points;
}

std::vector<Vec3d> edge_points(const HalfEdges& mesh, const std::vector<Vec3d>& of_faces) {
  std::vector<Vec3d> points(mesh.half_of_edge.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto half = mesh.half_of_edge[i];
    const Vec3d ends = mesh.points_m[mesh.from[half]] + mesh.points_m[mesh.from[mesh.next(half)]];
    const double sharp = std::min(1.0, mesh.edge_sharpness[i]);
    points[i] = ends / 2;
    if (sharp == 1) continue;
    const Vec3d smooth = (ends + of_faces[mesh.face[half]] + of_faces[mesh.face[mesh.opposite[half]]]) / 4;
    points[i] = sharp * points[i] + (1 - sharp) * smooth;
  }
  return points;
}

std::vector<Surroundings> surroundings(const HalfEdges& mesh, const std::vector<Vec3d>& of_faces) {
  std::vector<Surroundings> around(mesh.points_m.size());
  for (std::size_t h = 0; h < mesh.from.size(); ++h) {
    auto& here = around[mesh.from[h]];
    here.valence += 1;
    here.face_points_m += of_faces[mesh.face[h]];
  }
  for (std::size_t i = 0; i < mesh.half_of_edge.size(); ++i) {
    const auto start = mesh.from[mesh.half_of_edge[i]];
    const auto end = mesh.from[mesh.next(mesh.half_of_edge[i])];
    for (const auto& [here, other] : {std::pair(start, end), std::pair(end, start)}) {
      const Vec3d other_m = mesh.points_m[other];
      around[here].edge_ends_m += other_m;
      if (mesh.edge_sharpness[i] > 0) around[here].before.add(other_m);
      if (after_a_step(mesh.edge_sharpness[i]) > 0) around[here].after.add(other_m);
      around[here].end(mesh.edge_sharpness[i]);
    }
  }
  for (std::size_t i = 0; i < around.size(); ++i) around[i].end(mesh.point_sharpness[i]);
  return around;
}

std::vector<Vec3d> moved_points(const HalfEdges& mesh, const std::vector<Vec3d>& of_faces) {
  std::vector<Vec3d> points(mesh.points_m.size());
  const auto around = surroundings(mesh, of_faces);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Rule before = rule_at(mesh.point_sharpness[i] > 0, around[i].before);
    const Rule after = rule_at(after_a_step(mesh.point_sharpness[i]) > 0, around[i].after);
    points[i] = moved_by(before, mesh.points_m[i], around[i], around[i].before);
    if (before == after) continue;
    const double weight = std::min(1.0, around[i].ending / around[i].ending_count);
    const Vec3d next = moved_by(after, mesh.points_m[i], around[i], around[i].after);
    points[i] = weight * points[i] + (1 - weight) * next;
  }
  return points;
}

// Half edges 4 h to 4 h + 3 of the quadrilateral of half edge h: to the point of its edge, to that of its
// face, to that of the edge before it, and back.
void connect_quadrilaterals(const HalfEdges& mesh, HalfEdges& out) {
  const auto points = static_cast<std::uint32_t>(mesh.points_m.size());
  const auto edges = static_cast<std::uint32_t>(mesh.half_of_edge.size());
  const auto opposite_of = [&](std::uint32_t half, std::uint32_t place) {
    return half == kNoHalfEdge ? kNoHalfEdge : 4 * half + place;
  };
  // The half of an edge at the start of one of its half edges, or at its end.
  const auto half_at_start = [&](std::uint32_t h) {
    return 2 * mesh.edge[h] + (mesh.half_of_edge[mesh.edge[h]] == h ? 0U : 1U);
  };
  for (std::uint32_t h = 0; h < mesh.from.size(); ++h) {
    const auto before = mesh.previous(h);
    const auto across = mesh.opposite[h];
    out.first_of_face.push_back(4 * h);
    out.face.insert(out.face.end(), 4, h);
    out.from.insert(out.from.end(), {mesh.from[h], points + mesh.edge[h], points + edges + mesh.face[h],
                                     points + mesh.edge[before]});
    out.opposite.insert(out.opposite.end(),
                        {across == kNoHalfEdge ? kNoHalfEdge : 4 * mesh.next(across) + 3,
                         4 * mesh.next(h) + 2, 4 * before + 1, opposite_of(mesh.opposite[before], 0)});
    out.edge.insert(out.edge.end(),
                    {half_at_start(h), 2 * edges + h, 2 * edges + before, half_at_start(before) ^ 1U});
  }
  out.first_of_face.push_back(static_cast<std::uint32_t>(out.from.size()));
}

void number_half_edges(HalfEdges& out, std::size_t edges) {
  out.half_of_edge.assign(edges, kNoHalfEdge);
  for (std::uint32_t h = 0; h < out.edge.size(); ++h)
    if (out.half_of_edge[out.edge[h]] == kNoHalfEdge) out.half_of_edge[out.edge[h]] = h;
}

}  // namespace

HalfEdges subdivide(const HalfEdges& mesh) {
  HalfEdges out;
  const auto of_faces = face_points(mesh);
  const auto of_edges = edge_points(mesh, of_faces);
  out.points_m = moved_points(mesh, of_faces);
  out.points_m.insert(out.points_m.end(), of_edges.begin(), of_edges.end());
  out.points_m.insert(out.points_m.end(), of_faces.begin(), of_faces.end());
  out.point_sharpness.assign(out.points_m.size(), 0);
  std::transform(mesh.point_sharpness.begin(), mesh.point_sharpness.end(), out.point_sharpness.begin(),
                 after_a_step);
  const std::size_t edges = mesh.half_of_edge.size();
  out.edge_sharpness.assign(2 * edges + mesh.from.size(), 0);
  for (std::size_t i = 0; i < 2 * edges; ++i)
    out.edge_sharpness[i] = after_a_step(mesh.edge_sharpness[i / 2]);
  connect_quadrilaterals(mesh, out);
  number_half_edges(out, out.edge_sharpness.size());
  return out;
}

}  // namespace orbs::scene
