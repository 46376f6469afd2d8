// orbs qualify, with a renderer that paints what the references hold.
#include "cli/sandbox.h"
#include "image/image_io.h"

#include <gtest/gtest.h>

using namespace orbs;
using cli_tests::Sandbox;

TEST(QualifyCommand, LeavesWhatTheGatesSeeForTheNextRun) {
  const Sandbox sandbox;
  EXPECT_EQ(sandbox.orbs({"run", "-r", "good", "-c", "m1_grey", "-o", "control"}).status, 0);
  const auto answer = sandbox.orbs({"qualify", "control", "-r", "good", "-c", "m1_grey"});
  EXPECT_EQ(answer.status, 0) << answer.text;
  EXPECT_NE(answer.text.find("2 of 2 gates are qualified"), std::string::npos) << answer.text;
  EXPECT_NE(answer.text.find("'R and G swapped' is no fault here: it leaves the reference as it is"),
            std::string::npos);
  EXPECT_NE(sandbox.read("references/qualification.json").find("\"fault\": \"one NaN\""), std::string::npos);
  sandbox.orbs({"run", "-r", "good", "-c", "m1_grey", "-o", "next"});
  EXPECT_NE(sandbox.read("next/results.json").find("more or less light everywhere is a remark"),
            std::string::npos);
}

TEST(QualifyCommand, FailsForAGateThatCannot) {
  const Sandbox sandbox;
  sandbox.write("cases/m1_grey/case.json",
                R"({"format": "orbs-case/2", "requirement": "M1", "title": "Grey", "tests": "t",
  "typical_mistake": "m", "gates": [
    {"metric": "psnr_srgb8", "min": 0, "reason": "a gate that cannot fail"},
    {"metric": "mean_ratio_r", "min": -1, "max": 1, "reason": "a gate that cannot fail"},
    {"metric": "mean_ratio_g", "min": -1, "max": 1, "reason": "a gate that cannot fail"},
    {"metric": "mean_ratio_b", "min": -1, "max": 1, "reason": "a gate that cannot fail"},
    {"metric": "local_bias", "max": 1, "reason": "a gate that cannot fail"}],
  "scenes": [{"name": "grey", "file": "grey.json", "spp": 8}, {"name": "v1.5", "file": "grey.json", "spp": 8}]})");
  sandbox.orbs({"run", "-r", "good", "-c", "m1_grey", "-o", "control"});
  const auto answer = sandbox.orbs({"qualify", "control", "-r", "good", "-c", "m1_grey"});
  EXPECT_EQ(answer.status, 1) << answer.text;
  EXPECT_NE(answer.text.find("m1_grey grey: '+2 % light' is not rejected: pass"), std::string::npos)
      << answer.text;
}

TEST(QualifyCommand, NeedsAControlImage) {
  const Sandbox sandbox;
  sandbox.orbs({"run", "-r", "exit3", "-c", "m1_grey", "-o", "broken"});
  const auto answer = sandbox.orbs({"qualify", "broken", "-r", "exit3", "-c", "m1_grey"});
  EXPECT_EQ(answer.status, 1) << answer.text;
  EXPECT_NE(answer.text.find("a control image is not accepted: not tried"), std::string::npos) << answer.text;
}

// Noise that both share cancels in the comparison: every gate would accept such an image.
TEST(QualifyCommand, TakesNoImageWithTheSeedOfTheReference) {
  const Sandbox sandbox;
  sandbox.orbs({"run", "-r", "good", "-c", "m1_grey", "-o", "control"});
  for (const auto& file : {"references/grey.exr", "control/good/grey/result.exr"}) {
    auto image = image::read_image(sandbox.folder() / file);
    image.attributes["orbs.seed"] = "7";
    image::write_exr(image, sandbox.folder() / file);
  }
  const auto answer = sandbox.orbs({"qualify", "control", "-r", "good", "-c", "m1_grey", "-s", "grey"});
  EXPECT_EQ(answer.status, 1) << answer.text;
  EXPECT_NE(answer.text.find("its image has the seed of the reference"), std::string::npos) << answer.text;
}

TEST(QualifyCommand, AChangedCaseIsNotShownWithOldNumbers) {
  const Sandbox sandbox;
  sandbox.orbs({"run", "-r", "good", "-c", "m1_grey", "-o", "control"});
  sandbox.orbs({"qualify", "control", "-r", "good", "-c", "m1_grey"});
  const auto text = sandbox.read("cases/m1_grey/case.json");
  constexpr const char* kOutdated = "not known since the case or a reference changed";
  // The verdicts do not depend on what the case says in prose.
  auto reworded = text;
  reworded.replace(reworded.find("\"tests\": \"t\""), 12, "\"tests\": \"u\"");
  sandbox.write("cases/m1_grey/case.json", reworded);
  sandbox.orbs({"run", "-r", "good", "-c", "m1_grey", "-o", "reworded"});
  EXPECT_EQ(sandbox.read("reworded/results.json").find(kOutdated), std::string::npos);
  auto stricter = text;
  stricter.insert(1, "\"gates\": [{\"metric\": \"l1\", \"max\": 9, \"reason\": \"r\"}], ");
  sandbox.write("cases/m1_grey/case.json", stricter);
  sandbox.orbs({"run", "-r", "good", "-c", "m1_grey", "-o", "stricter"});
  EXPECT_NE(sandbox.read("stricter/results.json").find(kOutdated), std::string::npos);
}
