#pragma once

#include "importer/import.h"
#include "importer/nodes.h"

#include <string>
#include <vector>

namespace orbs::importer {

/// How the image is to be.
struct View {
  std::string camera;     // its name, or that of its node; "": the first of the scene
  int longer_side = 512;  // of the image in pixels, unless the file says its size
};

/// Sets the camera of the scene: the wanted one, or one that frames all that is drawn. InputError where there
/// is no such camera, or it has no view.
void set_camera(Import& import, const std::vector<PlacedNode>& nodes, const View& view);

}  // namespace orbs::importer
