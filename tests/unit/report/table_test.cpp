#include "report/table.h"

#include "base/text.h"
#include "base/text_table.h"

#include <algorithm>
#include <cstdlib>
#include <limits>

#include <gtest/gtest.h>

using namespace orbs::results;
using orbs::report::summary_text;

namespace {

RunRecord small_run() {
  RunRecord run;
  run.requirements = {
      {"M1", "Lambert", {{"a", {true, Verdict::Pass, 41.204, ""}}, {"bb", {true, Verdict::Fail, 9.5, ""}}}},
      {"M2",
       "\u00c9mission",
       {{"a", {true, Verdict::Pass, std::numeric_limits<double>::infinity(), ""}},
        {"bb", {false, Verdict::Unsupported, std::nullopt, ""}}}}};
  run.renderers = {{"a", "", "a 1.0", "/a", "G1/M2", "M2", {{"pass", 2}}, 3, 4},
                   {"bb", "", "", "/bb", "M1", "M0", {{"fail", 1}, {"unsupported", 1}}, 1, 2}};
  TargetRecord bad;
  bad.requirement = "M1";
  bad.target = "101";
  bad.renderer = "bb";
  bad.verdict = Verdict::Fail;
  bad.reason = "psnr_srgb8 is 9.5 dB, at least 35 is needed";
  TargetRecord unsupported = bad;
  unsupported.requirement = "M2";
  unsupported.verdict = Verdict::Unsupported;
  unsupported.reason = "bb does not declare M2";
  TargetRecord same = unsupported;
  same.target = "102";
  run.targets = {unsupported, same, bad};
  return run;
}

}  // namespace

TEST(Table, HasALinePerRequirementAndAColumnPerRenderer) {
  EXPECT_EQ(summary_text(small_run(), {}),
            "    requirement      dB a         dB bb\n"
            "M1  Lambert       41.20 pass    9.50 fail\n"
            "M2  \u00c9mission        inf pass       - unsupported\n"
            "\n"
            "a   declared G1/M2 \u00b7 measured M2\n"
            "    2 pass \u00b7 3.0 s of rendering, 4.0 s of CPU \u00b7 a 1.0\n"
            "bb  declared M1 \u00b7 measured M0\n"
            "    1 unsupported, 1 fail \u00b7 1.0 s of rendering, 2.0 s of CPU\n"
            "\n"
            "fail         bb  M1  101       psnr_srgb8 is 9.5 dB, at least 35 is needed\n"
            "unsupported  bb  M2  101, 102  bb does not declare M2\n");
}

// M1 and M2 of renderer a are judged by image 101, and M1 of bb by another one.
TEST(Table, EqualNumbersOfOneImageAreExplained) {
  auto run = small_run();
  run.requirements[1].cells.at("a").lowest_psnr_db = 41.204;
  const auto judged = [&](const char* requirement, const char* renderer, const char* image, double psnr_db) {
    TargetRecord target;
    target.requirement = requirement;
    target.target = image;
    target.renderer = renderer;
    target.verdict = Verdict::Pass;
    target.measures = {{"psnr_srgb8", psnr_db, "dB", ""}};
    run.targets.push_back(target);
  };
  judged("M1", "a", "101", 41.204);
  judged("M1", "bb", "102", 9.5);
  judged("M2", "a", "103", 50);
  EXPECT_EQ(summary_text(run, {}).find("Equal numbers"), std::string::npos);
  judged("M2", "a", "101", 41.204);
  EXPECT_NE(summary_text(run, {}).find("\nEqual numbers are of one image: M1, M2 (101)\n\na   declared"),
            std::string::npos)
      << summary_text(run, {});
  EXPECT_NE(summary_text(run, {false, 30}).find("\nEqual numbers are of one\nimage: M1, M2 (101)\n"),
            std::string::npos)
      << summary_text(run, {false, 30});
}

TEST(Table, TheRuleStandsBelowItWhereAnImagePassesWithoutItsNoise) {
  auto run = small_run();
  EXPECT_EQ(summary_text(run, {}).find("without"), std::string::npos);
  auto& cell = run.requirements[0].cells.at("a");
  cell.lowest_psnr_db = 30.54;
  cell.lowest_psnr_without_noise_db = 37.2;
  const auto text = summary_text(run, {});
  EXPECT_NE(text.find(" 30.54 pass, 37.2 dB without noise "), std::string::npos) << text;
  EXPECT_NE(text.find("\nNumbers are the PSNR of the images in dB."), std::string::npos) << text;
}

TEST(Table, WithColourItHasTheSameTextBetweenTheEscapes) {
  auto coloured = summary_text(small_run(), {true});
  EXPECT_NE(coloured, summary_text(small_run(), {}));
  for (auto at = coloured.find('\x1b'); at != std::string::npos; at = coloured.find('\x1b'))
    coloured.erase(at, coloured.find('m', at) - at + 1);
  EXPECT_EQ(coloured, summary_text(small_run(), {}));
}

TEST(Table, WidthsCountCharactersAndNotBytes) {
  EXPECT_EQ(orbs::display_width("\u00c9 \u00b7"), 3U);
  EXPECT_EQ(orbs::display_width("\x1b[32mpass\x1b[0m"), 4U);
}

TEST(Table, AnInterruptedRunAndRenderersLeftOutAreMentioned) {
  auto run = small_run();
  run.interrupted = true;
  run.left_out = {{"cycles", "there is no program 'blender' here"}};
  const auto text = summary_text(run, {});
  EXPECT_NE(text.find("cycles was left out: there is no program 'blender' here"), std::string::npos);
  EXPECT_NE(text.find("The run was interrupted"), std::string::npos);
}

TEST(Table, RenderersThatCouldHaveReadTheReferencesAreNamed) {
  auto run = small_run();
  EXPECT_EQ(summary_text(run, {}).find("references were not hidden"), std::string::npos);
  run.renderers[1].could_read_references = true;
  EXPECT_NE(summary_text(run, {}).find("The references were not hidden from bb,"), std::string::npos);
  EXPECT_EQ(summary_text(run, {}).find("hidden from a"), std::string::npos);
}

TEST(Table, WhatTheRunDidNotComeToIsCountedAndNotListed) {
  auto run = small_run();
  run.targets[2].verdict = Verdict::Skipped;
  run.targets[2].reason = "the run ended before its turn";
  run.renderers[1].counts = {{"skipped", 1}, {"unsupported", 1}};
  const auto text = summary_text(run, {});
  EXPECT_NE(text.find("1 skipped"), std::string::npos);
  EXPECT_EQ(text.find("before its turn"), std::string::npos) << text;
}

TEST(Table, ATargetThatFailsForSeveralRequirementsIsToldOnce) {
  auto run = small_run();
  for (const char* requirement : {"G1", "L1"}) {
    auto same = run.targets[2];
    same.requirement = requirement;
    run.targets.push_back(same);
  }
  EXPECT_NE(summary_text(run, {}).find("fail         bb  M1, G1, L1  101       psnr_srgb8 is"),
            std::string::npos)
      << summary_text(run, {});
}

// POV-Ray's 24 known failures had 63 remarks and a column of 200 characters.
TEST(Table, WithoutVerboseManyNamesAndTheRemarksOfFailuresAreShort) {
  auto run = small_run();
  run.targets[2].remarks = {"bias: the means differ", "bias: the image is turned"};
  run.targets[2].diagnosis = kNoUsualFault;
  run.targets[2].expectation = Expectation::Known;
  for (const char* name : {"103", "110", "113"}) {
    run.targets.push_back(run.targets[0]);
    run.targets.back().target = name;
  }
  run.targets.push_back(run.targets[2]);
  run.targets.back().target = "201";
  run.targets.back().verdict = Verdict::PassWithRemarks;
  run.targets.back().expectation = Expectation::None;
  run.targets.back().remarks = {"bias: beside edges"};
  const auto text = summary_text(run, {false, 0, false});
  EXPECT_NE(text.find("101, 102, 103 and 2 more  bb does not declare M2"), std::string::npos) << text;
  EXPECT_NE(text.find("of targets that do not pass: 2, which -v prints"), std::string::npos) << text;
  EXPECT_NE(text.find("bias: beside edges"), std::string::npos) << text;
  EXPECT_EQ(text.find("bias: the means differ"), std::string::npos) << text;
  EXPECT_EQ(text.find("diagnosis    bb  101"), std::string::npos) << text;
  const auto whole = summary_text(run, {});
  EXPECT_NE(whole.find("101, 102, 103, 110, 113"), std::string::npos) << whole;
  EXPECT_NE(whole.find("bias: the means differ"), std::string::npos) << whole;
  EXPECT_NE(whole.find("diagnosis  bb"), std::string::npos) << whole;
}

TEST(Table, IsNoWiderThanTheTerminal) {
  auto run = small_run();
  run.targets[2].reason =
      "one word after the other until the line is much longer than any terminal is wide, and on";
  for (const char* more : {"a-longer-name", "another-one", "the-last"}) {
    run.renderers.push_back(run.renderers[0]);
    run.renderers.back().name = more;
    for (auto& requirement : run.requirements) requirement.cells[more] = requirement.cells["a"];
  }
  const auto lines = orbs::split(summary_text(run, {false, 60}), '\n');
  EXPECT_GE(lines.size(), 5U);
  for (const auto& line : lines) EXPECT_LE(orbs::display_width(line), 60U) << line;
}

// A failure is one sentence in one line, below what it is of where there is no room beside it.
TEST(Table, AFailureIsOneSentenceThatFitsIntoTheTerminal) {
  auto run = small_run();
  run.targets[2].reason =
      "the mean over the block [152,8,216,72] is off by 1.74 % or more for certain, at most 1.2 % is allowed; "
      "bias: the means differ by more than noise";
  const auto lines = orbs::split(summary_text(run, {false, 80, false}), '\n');
  for (const auto& line : lines) EXPECT_LE(orbs::display_width(line), 80U) << line;
  const auto text = summary_text(run, {false, 80, false});
  EXPECT_NE(text.find(" 1.74 % or more ...\n"), std::string::npos) << text;
  EXPECT_EQ(text.find("noise"), std::string::npos) << text;
}

TEST(Table, OfAForeignRendererThatIsFarOffTheHintIsToProbe) {
  auto run = small_run();
  auto& bad = run.targets[2];
  bad.measures = {{"psnr_srgb8", 28.9, "dB", "", false}};
  bad.checks = {{"psnr_srgb8", false, "", 35, {}}};
  bad.reference_provenance = {{"program", "orbs-tracer"}};
  const std::string hint = "\nbb is far off in 101: 'orbs probe -r bb' checks whether";
  bad.checks.push_back({"local_bias", true, "", {}, 0.1});
  EXPECT_EQ(summary_text(run, {}).find(hint), std::string::npos) << "its tiles are right: it is only noisy";
  bad.checks.pop_back();
  EXPECT_NE(summary_text(run, {}).find(hint), std::string::npos);
  const auto is_silent = [&] { return summary_text(run, {}).find("orbs probe") == std::string::npos; };
  bad.measures[0].value = 29.1;
  EXPECT_TRUE(is_silent());
  bad.measures[0].value = 9.5;
  run.renderers[1].version = "orbs-tracer 0.1.0";
  EXPECT_TRUE(is_silent());
  run.renderers[1].version = "";
  bad.verdict = Verdict::Pass;
  EXPECT_TRUE(is_silent());
  bad.verdict = Verdict::Fail;
  EXPECT_FALSE(is_silent());
  bad.expectation = Expectation::Known;
  EXPECT_TRUE(is_silent());
}

TEST(Table, ARemarkIsToldOnceForAllCasesOfTheImage) {
  auto run = small_run();
  run.targets.resize(2);
  for (auto& target : run.targets) {
    target.renderer = "orbs";
    target.target = "101";
    target.verdict = Verdict::Pass;
    target.remarks = {"bias: darker"};
  }
  const auto text = summary_text(run, {});
  const auto first = text.find("bias: darker");
  ASSERT_NE(first, std::string::npos) << text;
  EXPECT_EQ(text.find("bias: darker", first + 1), std::string::npos) << text;
}

// A fault that is named leads the reason; what is none of the usual ones is listed once for each renderer,
// with the mistakes that are typical of its cases.
TEST(Table, ADiagnosisLeadsTheReasonOrTheTypicalMistakeIsTold) {
  auto run = small_run();
  run.targets.resize(4);
  const std::vector<std::string> names{"101", "101", "102", "103"};
  for (std::size_t i = 0; i < 4; ++i) {
    run.targets[i].renderer = "orbs";
    run.targets[i].target = names[i];
    run.targets[i].verdict = Verdict::Fail;
    run.targets[i].reason = "B is 41.5 % darker";
    run.targets[i].case_name = i < 2 ? "a" : "textures";
    run.targets[i].diagnosis =
        i < 2 ? "upside down: then 40.0 dB" : std::string(orbs::results::kNoUsualFault);
  }
  run.cases.push_back({"s", "textures", "M4", "", "", "Textures are not decoded from sRGB."});
  const auto text = summary_text(run, {});
  const auto first = text.find("upside down: then 40.0 dB; B is 41.5 % darker\n");
  ASSERT_NE(first, std::string::npos) << text;
  EXPECT_EQ(text.find("upside down", first + 1), std::string::npos) << text;
  EXPECT_NE(text.find("102, 103  none of the usual faults explains the error\n"), std::string::npos) << text;
  EXPECT_NE(text.find("102, 103  Textures are not decoded from sRGB.\n"), std::string::npos) << text;
}

TEST(Table, WhatNoiseHidesIsToldInOneLineOfTheRenderer) {
  auto run = small_run();
  for (auto& target : run.targets) target.hidden = "noise hides errors below 7 % over 16 x 16 px";
  EXPECT_NE(summary_text(run, {}).find(
                "noise  bb  hides errors of 2 % over 64 x 64 px or of 5 % over 16 x 16 px in "
                "101, 102\n"),
            std::string::npos)
      << summary_text(run, {});
}

TEST(Table, NoColourGoesToWhatIsNoTerminal) { EXPECT_FALSE(orbs::report::style_for(-1).colour); }
