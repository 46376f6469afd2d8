#pragma once

#include "scene/scene.h"

#include <string>
#include <vector>

namespace orbs::adapters {

/// A mesh in one material and the places where it stands.
struct Part {
  scene::Mesh mesh;  // triangles that have area
  int material = 0;
  std::vector<Mat4> places;  // at least one
};

/// What the instances of a scene show, for renderers that give a material to a whole mesh and apply no
/// texture matrices: remap lists are resolved, texture matrices are applied to the coordinates. Instances
/// that show the same share a part.
std::vector<Part> parts_of(const scene::Scene& scene);

/// A name for a comment of one line: what ends a line or controls a terminal becomes a space.
std::string one_line(const std::string& name);

}  // namespace orbs::adapters
