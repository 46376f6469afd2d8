#pragma once

#include "image/image.h"
#include "studies/probe/primary_visibility.h"
#include "studies/probe/scene.h"

#include <string>
#include <vector>

namespace orbs::studies {

/// Layers of surfaces that follow from primary visibility alone.
inline const std::vector<std::string> kProbedLayers{"depth", "position", "normal", "uv"};

struct LayerFindings {
  int compared = 0;  // pixels that one mesh covers completely
  std::string
      fault;  // the metric's words for what is off: "the layer 'depth' is along the ray ..."; "" if none is
};

/// Compares the named layers of an image with what `surfaces` are, by the metric layer_pixels. `surfaces` are
/// those of primary_visibility for the default grid.
LayerFindings compare_layers(const ProbeScene& probe,
                             const std::vector<VisibleSurface>& surfaces,
                             const image::Image& image,
                             const std::vector<std::string>& layers);

}  // namespace orbs::studies
