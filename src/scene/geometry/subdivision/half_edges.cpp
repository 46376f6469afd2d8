#include "scene/geometry/subdivision/half_edges.h"

#include "base/error.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

#include <fmt/format.h>

namespace orbs::scene {

namespace {

void check_faces(const ControlCage& cage) {
  if (cage.face_sizes.empty()) throw InputError("the cage has no faces");
  const std::size_t count = cage.points_m.size();
  std::size_t first = 0;
  for (std::size_t i = 0; i < cage.face_sizes.size(); ++i) {
    const std::size_t size = cage.face_sizes[i];
    if (size < 3) throw InputError(fmt::format("face {} has {} points, must have 3 or more", i, size));
    if (first + size > cage.face_points.size()) break;
    for (std::size_t k = first; k < first + size; ++k)
      if (cage.face_points[k] >= count)
        throw InputError(fmt::format("face {} has point {}, there are {} points, counted from 0", i,
                                     cage.face_points[k], count));
    const auto begin = cage.face_points.begin() + static_cast<std::ptrdiff_t>(first);
    std::vector<std::uint32_t> sorted(begin, begin + static_cast<std::ptrdiff_t>(size));
    std::sort(sorted.begin(), sorted.end());
    const auto twice = std::adjacent_find(sorted.begin(), sorted.end());
    if (twice != sorted.end()) throw InputError(fmt::format("face {} has point {} twice", i, *twice));
    first += size;
  }
  const auto wanted = std::accumulate(cage.face_sizes.begin(), cage.face_sizes.end(), std::size_t{0});
  if (wanted != cage.face_points.size())
    throw InputError(fmt::format("the faces take {} points, {} are given", wanted, cage.face_points.size()));
}

using DirectedEdge = std::pair<std::uint32_t, std::uint32_t>;
using HalfEdgeOf = std::map<DirectedEdge, std::uint32_t>;

HalfEdgeOf connect_faces(const ControlCage& cage, HalfEdges& mesh) {
  mesh.from = cage.face_points;
  mesh.first_of_face.push_back(0);
  for (std::size_t i = 0; i < cage.face_sizes.size(); ++i) {
    mesh.face.insert(mesh.face.end(), cage.face_sizes[i], static_cast<std::uint32_t>(i));
    mesh.first_of_face.push_back(static_cast<std::uint32_t>(mesh.face.size()));
  }
  HalfEdgeOf half_edge;
  for (std::uint32_t h = 0; h < mesh.from.size(); ++h) {
    const DirectedEdge ends{mesh.from[h], mesh.from[mesh.next(h)]};
    if (const auto [other, is_new] = half_edge.try_emplace(ends, h); !is_new)
      throw InputError(
          fmt::format("faces {} and {} both run from point {} to point {}: wind all faces counter-clockwise "
                      "seen from outside, and let no more than two meet at an edge",
                      mesh.face[other->second], mesh.face[h], ends.first, ends.second));
  }
  mesh.opposite.assign(mesh.from.size(), kNoHalfEdge);
  for (const auto& [ends, h] : half_edge)
    if (const auto back = half_edge.find({ends.second, ends.first}); back != half_edge.end())
      mesh.opposite[h] = back->second;
  return half_edge;
}

void number_edges(HalfEdges& mesh) {
  mesh.edge.resize(mesh.from.size());
  for (std::uint32_t h = 0; h < mesh.from.size(); ++h) {
    const bool is_boundary = mesh.opposite[h] == kNoHalfEdge;
    if (!is_boundary && mesh.opposite[h] < h) {
      mesh.edge[h] = mesh.edge[mesh.opposite[h]];
      continue;
    }
    mesh.edge[h] = static_cast<std::uint32_t>(mesh.half_of_edge.size());
    mesh.half_of_edge.push_back(h);
    mesh.edge_sharpness.push_back(is_boundary ? kInfinitelySharp : 0);
  }
}

void sharpen(const ControlCage& cage, const HalfEdgeOf& half_edge, HalfEdges& mesh) {
  for (const auto& [points, sharpness] : cage.creases)
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      auto found = half_edge.find({points[i], points[i + 1]});
      if (found == half_edge.end()) found = half_edge.find({points[i + 1], points[i]});
      if (found == half_edge.end())
        throw InputError(
            fmt::format("a crease runs from point {} to point {}, between which there is no edge", points[i],
                        points[i + 1]));
      double& known = mesh.edge_sharpness[mesh.edge[found->second]];
      known = std::max(known, sharpness);
    }
  for (const auto& [points, sharpness] : cage.corners)
    for (const auto point : points) {
      if (point >= mesh.points_m.size())
        throw InputError(fmt::format("a corner is point {}, there are {} points, counted from 0", point,
                                     mesh.points_m.size()));
      mesh.point_sharpness[point] = std::max(mesh.point_sharpness[point], sharpness);
    }
}

// The faces around a point are one fan if turning around it meets as many as there are.
void check_fans(const HalfEdges& mesh) {
  std::vector<std::uint32_t> missed(mesh.points_m.size(), 0);
  for (const auto point : mesh.from) ++missed[point];
  const auto first = first_half_edges(mesh);
  for (std::size_t i = 0; i < mesh.points_m.size(); ++i) {
    if (missed[i] == 0) throw InputError(fmt::format("point {} belongs to no face", i));
    std::uint32_t half = first[i];
    do {
      --missed[i];
      half = mesh.opposite[mesh.previous(half)];
    } while (half != kNoHalfEdge && half != first[i]);
    if (missed[i] != 0)
      throw InputError(
          fmt::format("point {} joins faces that share no edge there: give each group a separate point", i));
  }
}

}  // namespace

std::vector<std::uint32_t> first_half_edges(const HalfEdges& mesh) {
  std::vector<std::uint32_t> first(mesh.points_m.size(), kNoHalfEdge);
  for (std::uint32_t h = 0; h < mesh.from.size(); ++h)
    if (mesh.opposite[h] == kNoHalfEdge || first[mesh.from[h]] == kNoHalfEdge) first[mesh.from[h]] = h;
  return first;
}

HalfEdges connect(const ControlCage& cage) {
  check_faces(cage);
  HalfEdges mesh;
  mesh.points_m = cage.points_m;
  mesh.point_sharpness.assign(cage.points_m.size(), 0);
  const auto half_edge = connect_faces(cage, mesh);
  number_edges(mesh);
  check_fans(mesh);
  sharpen(cage, half_edge, mesh);
  return mesh;
}

}  // namespace orbs::scene
