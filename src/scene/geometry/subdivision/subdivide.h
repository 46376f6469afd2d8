#pragma once

#include "scene/geometry/subdivision/half_edges.h"

namespace orbs::scene {

/// One step of Catmull and Clark (1978) with the creases of DeRose, Kass and Truong (1998). Each corner of a
/// face becomes a quadrilateral: point of the face's corner, of the edge after it, of the face, of the edge
/// before it; quadrilateral i is that of half edge i. Points of corners come first, in their old order, then
/// those of edges, then those of faces. Boundaries are sharp edges.
///
/// Where the sharpness of edges ends within the step, a point lies between where the rules of before and
/// after would put it, by the mean of the sharpnesses that end there. For edges of one sharpness this is
/// equation 26 of DeRose et al.; for others it is the rule of Pixar's OpenSubdiv, which blends the rules and
/// not the sharpnesses.
HalfEdges subdivide(const HalfEdges& mesh);

}  // namespace orbs::scene
