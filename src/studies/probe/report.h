#pragma once

#include "studies/probe/compare.h"
#include "studies/probe/layers_pass.h"

#include <string>
#include <vector>

/// What the probe has found, as plain data.

namespace orbs::studies {

/// One pass of a scene by a renderer.
struct ProbeImage {
  std::string unsupported;  // the reason why there is none; "" if there is one
  std::string no_image;     // how the renderer failed; "" if it did not
  ProbeFindings findings;
  std::string note{};            // what a reader must know of how it came about; "" for nothing
  bool has_equal_seeds = false;  // two seeds gave the same image
};

/// The pass of layers: of each layer by itself whether the renderer has it.
struct ProbeLayers {
  std::vector<std::string> layers;  // that were compared
  std::string unsupported;          // the reason why there is none; "" if there is one
  std::string no_image;             // how the renderer failed; "" if it did not
  LayerFindings findings;
};

struct ProbeRecord {
  std::string scene;
  std::string renderer;
  ProbeImage id_pass;
  ProbeImage uv_pass;
  ProbeImage second_uv_pass;  // compares nothing where no mesh has second coordinates
  ProbeImage frames;  // of a scene with normal maps or a grain, for renderers with normal maps and points
  ProbeLayers layers;
  std::vector<std::string> object_names;
};

/// Wrong: the renderer failed, or a pixel shows a wrong object or wrong coordinates. NotChecked: there is no
/// id pass for this renderer, or noise hides what would be compared. A renderer without textured emission is
/// right without its uv pass.
enum class ProbeVerdict { Right, Wrong, NotChecked };
ProbeVerdict probe_verdict(const ProbeRecord& record);

/// "ok", "not checked" with the reason, or what differs: "scene mapping differs: instance 'box', material
/// 'red' (412 pixels, first at (3, 7), where there is nothing)".
std::string probe_message(const ProbeRecord& record);

/// The record for programs: a JSON list, one entry for each scene and renderer.
std::string probe_json(const std::vector<ProbeRecord>& records);

}  // namespace orbs::studies
