// The cases of motion, whose right images are known: the tracer shows them, and instants fail.
#include "property/judged_case.h"
#include "registry/configuration.h"
#include "scene/effects/effects.h"
#include "scene/load/load_scene.h"
#include "scene/motion.h"

using namespace orbs;

using tests::expect_verdict;
using tests::judged;

TEST(MotionCases, KnownImagesAreShownAndInstantsFail) {
  const auto suite =
      registry::find_suite(registry::load_configuration(ORBS_SOURCE_DIR "/configuration.json"), "motion");
  for (const auto& one_case : registry::load_cases(suite))
    for (const auto& one : one_case.scenes) {
      const auto scene = scene::load_scene(one.file, {}, one.camera);
      const auto expect = [&](const scene::Scene& shown, results::Verdict expected, const char* what) {
        // A shutter that is 0.05 shorter moves an edge by too little for smaller images.
        expect_verdict(judged(one_case, one.name, shown, suite.references, registry::FullSize), expected,
                       what);
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
