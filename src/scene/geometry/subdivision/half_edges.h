#pragma once

#include "scene/geometry/subdivision/subdivision_surface.h"

#include <cstddef>

namespace orbs::scene {

/// Stands for the neighbour that a half edge on the boundary does not have.
constexpr std::uint32_t kNoHalfEdge = std::numeric_limits<std::uint32_t>::max();

/// Polygons that know their neighbours. Each edge of a face is a half edge, which runs counter-clockwise
/// around the face to its left; those of one face follow each other.
struct HalfEdges {
  std::vector<Vec3d> points_m;
  std::vector<double> point_sharpness;
  std::vector<std::uint32_t> first_of_face;  // first half edge of each face, and at last how many there are
  // By half edge:
  std::vector<std::uint32_t> from;  // the point where it starts
  std::vector<std::uint32_t> face;
  std::vector<std::uint32_t>
      opposite;  // that of the other face, running backwards; kNoHalfEdge on a boundary
  std::vector<std::uint32_t> edge;
  // By edge:
  std::vector<std::uint32_t> half_of_edge;  // the first of its half edges
  std::vector<double> edge_sharpness;       // infinite on a boundary

  std::size_t face_count() const { return first_of_face.size() - 1; }
  std::uint32_t next(std::uint32_t half) const {
    return half + 1 == first_of_face[face[half] + 1] ? first_of_face[face[half]] : half + 1;
  }
  std::uint32_t previous(std::uint32_t half) const {
    return half == first_of_face[face[half]] ? first_of_face[face[half] + 1] - 1 : half - 1;
  }
};

/// The neighbours of a cage's faces. InputError that names the face, edge or point, without a place in a
/// file, unless the cage is a manifold: faces of three and more different points of the cage, wound alike,
/// at most two at an edge, one fan of faces around each point; creases along edges.
HalfEdges connect(const ControlCage& cage);

/// For each point a half edge that starts there: where the point lies on the boundary the one from which
/// turning counter-clockwise meets all others.
std::vector<std::uint32_t> first_half_edges(const HalfEdges& mesh);

}  // namespace orbs::scene
