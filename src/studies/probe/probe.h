#pragma once

#include "registry/configuration.h"
#include "run/plan/plan.h"
#include "studies/context.h"
#include "studies/probe/report.h"

#include <filesystem>
#include <string>
#include <vector>

/// Checks that a renderer places camera, geometry and texture coordinates as the scene says, before its light
/// is compared with anything.
namespace orbs::studies {

struct ProbeSettings {
  int most_px = 128;  // longer side of an image
  int spp = 16;
  int threads = 2;
  std::filesystem::path keep{};  // folder for all scenes and images; "": they are deleted
};

/// Probes each scene of the plan with each of its renderers, scene by scene. Returns what is complete if the
/// user interrupts.
std::vector<ProbeRecord> run_probe(const run::Plan& plan,
                                   const ProbeSettings& settings,
                                   const StudyContext& context);

}  // namespace orbs::studies
