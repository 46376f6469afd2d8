#pragma once

#include "registry/configuration.h"
#include "runner/plan.h"
#include "studies/probe_compare.h"

#include <atomic>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

/// Gate zero of every comparison between renderers: is the scene where it should be, before anybody asks how
/// it is lit?
namespace orbs::studies {

struct ProbeSettings {
  int most_px = 128;  // longer side of an image
  int spp = 16;
  int threads = 2;
};

struct ProbeContext {
  const std::atomic<bool>* stop = nullptr;
  std::function<void(const std::string&)> say;
};

/// One of the two images of a scene by a renderer.
struct ProbeImage {
  std::string unsupported;  // why there is none; "" when there is one
  std::string no_image;     // how the renderer failed
  ProbeFindings findings;
};

struct ProbeRecord {
  std::string scene;
  std::string renderer;
  ProbeImage things;
  ProbeImage coordinates;
  std::vector<std::string> thing_names;
};

/// Probes each scene of the plan with each of its renderers, scene by scene. What was done when the user
/// interrupts.
std::vector<ProbeRecord> run_probe(const runner::Plan& plan,
                                   const ProbeSettings& settings,
                                   const ProbeContext& context);

/// True when no renderer failed and nothing is where it should not be.
bool is_mapped_right(const ProbeRecord& record);

/// "ok", or what differs: "scene mapping differs: instance 'box', material 'red' (412 pixels, first at (3,
/// 7), where there is nothing)".
std::string probe_message(const ProbeRecord& record);

/// The record for programs: a JSON list, one entry for each scene and renderer.
std::string probe_json(const std::vector<ProbeRecord>& records);

}  // namespace orbs::studies
