// The cases of motion, whose right images are known: the tracer shows them, and instants fail.
#include "judge/judge.h"
#include "registry/cases.h"
#include "registry/configuration.h"
#include "scene/effects/effects.h"
#include "scene/load/load_scene.h"
#include "scene/motion.h"
#include "tracer/render.h"
#include "tracer/world/build_world.h"

#include <atomic>

#include <gtest/gtest.h>

using namespace orbs;

namespace {

image::Image rendered(const scene::Scene& scene) {
  const std::atomic<bool> never{false};
  return tracer::render(tracer::make_world(scene), {.samples_per_pixel = 256}, never,
                        [](const tracer::Progress&) {})
      .image;
}

results::Verdict verdict_of(const registry::Case& one_case,
                            const std::string& target,
                            const scene::Scene& scene,
                            const std::filesystem::path& references) {
  const auto reference = judge::load_reference(one_case, target, references);
  EXPECT_TRUE(reference.image) << reference.problem;
  results::TargetRecord record;
  record.target = target;
  if (reference.image)
    judge::judge_image(one_case, rendered(scene), reference, {1, judge::Measured::ForTheVerdict}, record);
  return record.verdict;
}

}  // namespace

TEST(MotionCases, KnownImagesAreShownAndInstantsFail) {
  const auto suite =
      registry::find_suite(registry::load_configuration(ORBS_SOURCE_DIR "/configuration.json"), "motion");
  for (const auto& one_case : registry::load_cases(suite))
    for (const auto& one : one_case.scenes) {
      const auto scene = scene::load_scene(one.file, {}, one.camera);
      const auto verdict = [&](const scene::Scene& shown) {
        return verdict_of(one_case, one.name, shown, suite.references);
      };
      EXPECT_EQ(verdict(scene), results::Verdict::Pass) << one.name;
      auto instant = scene;
      scene::leave_out(scene::Effect::Motion, instant);
      EXPECT_EQ(verdict(instant), results::Verdict::Fail) << one.name << " without motion";
      EXPECT_EQ(verdict(scene::at_time(scene, 0.5)), results::Verdict::Fail)
          << one.name << " at half the frame";
      auto shorter = scene;
      shorter.camera.shutter.close -= 0.05;
      EXPECT_EQ(verdict(shorter), results::Verdict::Fail)
          << one.name << " with a shutter that closes earlier";
    }
}
