#pragma once

#include "registry/configuration.h"
#include "runner/plan.h"
#include "studies/context.h"
#include "studies/probe_compare.h"

#include <string>
#include <vector>

/// Checks that a renderer places camera, geometry and texture coordinates as the scene says, before its light
/// is compared with anything.
namespace orbs::studies {

struct ProbeSettings {
  int most_px = 128;  // longer side of an image
  int spp = 16;
  int threads = 2;
};

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

/// Probes each scene of the plan with each of its renderers, scene by scene. Returns what is complete if the
/// user interrupts.
std::vector<ProbeRecord> run_probe(const runner::Plan& plan,
                                   const ProbeSettings& settings,
                                   const StudyContext& context);

/// True if the renderer gave both images and no pixel shows a wrong object or wrong coordinates.
bool is_mapped_right(const ProbeRecord& record);

/// "ok", or what differs: "scene mapping differs: instance 'box', material 'red' (412 pixels, first at (3,
/// 7), where there is nothing)".
std::string probe_message(const ProbeRecord& record);

/// The record for programs: a JSON list, one entry for each scene and renderer.
std::string probe_json(const std::vector<ProbeRecord>& records);

}  // namespace orbs::studies
