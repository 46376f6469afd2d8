#pragma once

#include "judge/judge.h"
#include "registry/cases.h"
#include "scene/scene.h"
#include "tracer/render.h"
#include "tracer/world/build_world.h"

#include <atomic>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>

/// The scenes of cases whose right images are known, rendered and judged as a run does it.
namespace orbs::tests {

inline image::Image rendered(const scene::Scene& scene, int spp) {
  const std::atomic<bool> never{false};
  return tracer::render(tracer::make_world(scene), {.samples_per_pixel = spp}, never,
                        [](const tracer::Progress&) {})
      .image;
}

inline results::TargetRecord judged(const registry::Case& one_case,
                                    const std::string& target,
                                    const scene::Scene& scene,
                                    const std::filesystem::path& references) {
  const auto reference = judge::load_reference(one_case, target, references);
  EXPECT_TRUE(reference.image) << reference.problem;
  results::TargetRecord record;
  // As a run does: with more samples until noise leaves nothing open.
  constexpr int kMost = 1 << 16;
  for (int spp = 256; reference.image && spp <= kMost; spp *= 4) {
    record = {};
    record.target = target;
    judge::judge_image(one_case, rendered(scene, spp), reference, {1, judge::Measured::ForTheVerdict},
                       record);
    if (record.verdict != results::Verdict::Inconclusive) break;
  }
  return record;
}

inline void expect_verdict(const results::TargetRecord& record,
                           results::Verdict expected,
                           const std::string& what) {
  EXPECT_EQ(results::verdict_name(record.verdict), results::verdict_name(expected))
      << record.target << what << ": " << record.reason;
}

}  // namespace orbs::tests
