#pragma once

#include "studies/probe/compare.h"

#include <string>
#include <vector>

/// What the probe has found, as plain data.
namespace orbs::studies {

/// One pass of a scene by a renderer.
struct ProbeImage {
  std::string unsupported;  // the reason why there is none; "" if there is one
  std::string no_image;     // how the renderer failed; "" if it did not
  ProbeFindings findings;
};

struct ProbeRecord {
  std::string scene;
  std::string renderer;
  ProbeImage id_pass;
  ProbeImage uv_pass;
  std::vector<std::string> object_names;
};

}  // namespace orbs::studies
