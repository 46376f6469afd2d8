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

image::Image rendered(const scene::Scene& scene, int spp) {
  const std::atomic<bool> never{false};
  return tracer::render(tracer::make_world(scene), {.samples_per_pixel = spp}, never,
                        [](const tracer::Progress&) {})
      .image;
}

results::TargetRecord judged(const registry::Case& one_case,
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

void expect_verdict(const results::TargetRecord& record, results::Verdict expected, const std::string& what) {
  EXPECT_EQ(results::verdict_name(record.verdict), results::verdict_name(expected))
      << record.target << what << ": " << record.reason;
}

}  // namespace

TEST(MotionCases, KnownImagesAreShownAndInstantsFail) {
  const auto suite =
      registry::find_suite(registry::load_configuration(ORBS_SOURCE_DIR "/configuration.json"), "motion");
  for (const auto& one_case : registry::load_cases(suite))
    for (const auto& one : one_case.scenes) {
      const auto scene = scene::load_scene(one.file, {}, one.camera);
      const auto expect = [&](const scene::Scene& shown, results::Verdict expected, const char* what) {
        expect_verdict(judged(one_case, one.name, shown, suite.references), expected, what);
      };
      expect(scene, results::Verdict::Pass, "");
      auto instant = scene;
      scene::leave_out(scene::Effect::Motion, instant);
      expect(instant, results::Verdict::Fail, " without motion");
      expect(scene::at_time(scene, 0.5), results::Verdict::Fail, " at half the frame");
      // A shutter that is 0.05 shorter changes the light of t1-lamp by 0.1 %, which is allowed.
      auto shorter = scene;
      shorter.camera.shutter.close -= one.name == "t1-lamp" ? 0.25 : 0.05;
      expect(shorter, results::Verdict::Fail, " with a shutter that closes earlier");
    }
}
