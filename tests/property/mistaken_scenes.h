#pragma once

#include "property/judged_case.h"
#include "registry/configuration.h"
#include "scene/load/load_scene.h"

#include <functional>
#include <set>
#include <string>
#include <vector>

/// Cases of the suite everyday whose images are known: the tracer shows them, and typical mistakes fail.
namespace orbs::tests {

struct Mistake {
  std::string what;
  std::set<std::string> scenes;  // that show it; empty: all
  std::function<void(scene::Scene&)> make;
  int divisor = registry::QuarterSize;  // of the width and height at which it is seen
};

/// An image without noise has rounding alone, whose errors are alike: a remark, and none of the gates.
enum class Remarks { Refused, Allowed };

inline void expect_the_case_and_no_mistake(const std::string& name,
                                           const std::vector<Mistake>& mistakes,
                                           Remarks remarks = Remarks::Refused) {
  const auto suite =
      registry::find_suite(registry::load_configuration(ORBS_SOURCE_DIR "/configuration.json"), "everyday");
  for (const auto& one_case : registry::load_cases(suite)) {
    if (one_case.name != name) continue;
    for (const auto& one : one_case.scenes) {
      const auto scene = scene::load_scene(one.file, {}, one.camera);
      const auto record = judged(one_case, one.name, scene, suite.references, registry::FullSize);
      const bool is_remark = record.verdict == results::Verdict::PassWithRemarks;
      if (!is_remark || remarks == Remarks::Refused) expect_verdict(record, results::Verdict::Pass, "");
      for (const auto& [what, scenes, make, divisor] : mistakes) {
        if (!scenes.empty() && !scenes.contains(one.name)) continue;
        auto wrong = scene;
        make(wrong);
        expect_verdict(judged(one_case, one.name, wrong, suite.references, divisor), results::Verdict::Fail,
                       " with " + what);
      }
    }
  }
}

}  // namespace orbs::tests
