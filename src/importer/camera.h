#pragma once

#include "importer/import.h"
#include "importer/nodes.h"

#include <optional>
#include <string>
#include <vector>

namespace orbs::importer {

/// What the user says of the image, which the file may leave open.
struct View {
  std::string camera;           // its name, or that of its node; "": the first of the scene
  int longer_side = 512;        // of the image in pixels, unless the file says its size
  std::optional<double> sky{};  // radiance of an even sky; nothing: none, unless nothing else shines
};

/// Sets the camera of the scene: the wanted one, or one that frames all that is drawn. InputError where there
/// is no such camera, or it has no view.
void set_camera(Import& import, const std::vector<PlacedNode>& nodes, const View& view);

}  // namespace orbs::importer
