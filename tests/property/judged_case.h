#pragma once

#include "judge/judge.h"
#include "registry/cases.h"
#include "registry/image_size.h"
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

inline scene::Scene reduced_scene(scene::Scene scene, int divisor) {
  scene.camera.width_px /= divisor;
  scene.camera.height_px /= divisor;
  return scene;
}

/// What is right is judged at full size, where details finer than a pixel of the quarter show; mistakes at
/// 1/4. As `orbs run` does at this size, with more samples until noise leaves nothing open.
inline results::TargetRecord judged(const registry::Case& one_case,
                                    const std::string& target,
                                    const scene::Scene& full,
                                    const std::filesystem::path& references,
                                    int divisor = registry::QuarterSize) {
  const auto reduced = registry::reduced_case(one_case, divisor);
  const auto reference = judge::load_reference(reduced, target, references, {}, {}, {divisor});
  EXPECT_TRUE(reference.image) << reference.problem;
  const auto scene = reduced_scene(full, divisor);
  results::TargetRecord record;
  constexpr int kMost = 1 << 18;
  for (int spp = 256; reference.image && spp <= kMost; spp *= 4) {
    record = {};
    record.target = target;
    judge::judge_image(reduced, rendered(scene, spp), reference, {1, judge::Measured::ForTheVerdict}, record);
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
