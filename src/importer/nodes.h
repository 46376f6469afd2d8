#pragma once

#include "base/matrix.h"
#include "importer/import.h"

#include <vector>

namespace orbs::importer {

/// A node of the scene that is drawn, and where it is in the world.
struct PlacedNode {
  int node = 0;
  Mat4 matrix;
};

/// The nodes of the file's default scene, or of its first, parents before children. InputError where they are
/// no tree: a node that is its own ancestor, or has two parents.
std::vector<PlacedNode> placed_nodes(const Source& source, Report& report);

/// Adds what the nodes show of meshes, with bones and morph targets as they rest.
void add_instances(Import& import, const std::vector<PlacedNode>& nodes);

}  // namespace orbs::importer
