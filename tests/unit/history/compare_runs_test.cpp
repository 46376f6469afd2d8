// Two runs compared: what is found, and how often something is found where nothing is.
#include "base/error.h"
#include "base/text.h"
#include "base/text_table.h"
#include "history/comparison_text.h"
#include "unit/history/made_up_run.h"

#include <algorithm>

#include <gtest/gtest.h>

using namespace orbs;
using history::Change;
using history::Direction;
using history::Quantity;

namespace {

bool has_change(const history::RunComparison& comparison,
                Quantity quantity,
                Direction direction,
                const std::string& renderer,
                const std::string& target) {
  return std::any_of(comparison.changes.begin(), comparison.changes.end(), [&](const Change& change) {
    return change.quantity == quantity && change.direction == direction && change.renderer == renderer &&
           change.target == target;
  });
}

}  // namespace

// The stated rate is 1 in 100. Of 200 pairs 7 or more then have an alarm with a probability of 0.4 %.
TEST(CompareRuns, RaisesNoMoreAlarmsThanStatedOnRunsOfEqualPrograms) {
  int alarms = 0;
  for (std::uint64_t pair = 0; pair < 200; ++pair) {
    const auto comparison = history::compare_runs(made_up::run(2 * pair + 1), made_up::run(2 * pair + 2));
    if (!comparison.changes.empty()) ++alarms;
  }
  EXPECT_LE(alarms, 6);
}

// Of 40 pairs; the rest has noise that is against it.
TEST(CompareRuns, OnePercentLessLightOfARendererIsFound) {
  int found = 0;
  for (std::uint64_t pair = 0; pair < 40; ++pair) {
    const auto comparison =
        history::compare_runs(made_up::run(2 * pair + 1), made_up::run(2 * pair + 2, {.light = 0.99}));
    if (has_change(comparison, Quantity::Light, Direction::Worse, "r0", "")) ++found;
  }
  EXPECT_EQ(found, 40);
}

// Two renderers of one run are compared like one renderer of two runs; the others are left out.
TEST(CompareRuns, ARendererStandsForAnother) {
  const auto run = made_up::run(1, {.renderers = 3, .light = 0.99});
  const auto alone = history::with_renderer(run, "r1", "r0");
  EXPECT_EQ(alone.renderers.size(), 1U);
  EXPECT_EQ(alone.targets.size(), 30U);
  EXPECT_EQ(alone.jobs.size(), 30U);
  const auto comparison =
      history::compare_runs(history::with_renderer(run, "r1", "r0"), history::with_renderer(run, "r0", "r0"));
  EXPECT_EQ(comparison.targets, 30U);
  EXPECT_TRUE(has_change(comparison, Quantity::Light, Direction::Worse, "r0", ""));
  for (const auto& change : comparison.changes) EXPECT_EQ(change.renderer, "r0");
}

TEST(CompareRuns, TenPercentMoreTimeOfARendererIsFound) {
  int found = 0;
  for (std::uint64_t pair = 0; pair < 40; ++pair) {
    const auto comparison =
        history::compare_runs(made_up::run(2 * pair + 1), made_up::run(2 * pair + 2, {.time = 1.1}));
    if (has_change(comparison, Quantity::Time, Direction::Worse, "r0", "")) ++found;
  }
  EXPECT_GE(found, 36);
}

// Whose renders are compared with those of the other: it is not the other that got faster.
TEST(CompareRuns, OfTwoRenderersTheSlowerOneIsNamedAndNotTheOther) {
  for (std::uint64_t pair = 0; pair < 10; ++pair)
    for (const auto& change : history::compare_runs(made_up::run(2 * pair + 1, {.renderers = 2}),
                                                    made_up::run(2 * pair + 2, {.renderers = 2, .time = 1.2}))
                                  .changes)
      EXPECT_EQ(change.renderer, "r0");
}

TEST(CompareRuns, AMachineThatIsSlowerAsAWholeIsNoSlowerRenderer) {
  auto after = made_up::run(2);
  for (auto& job : after.jobs) job.cost.cpu_seconds *= 1.2;
  EXPECT_TRUE(history::compare_runs(made_up::run(1), after).changes.empty());
}

TEST(CompareRuns, LessTimeIsBetterAndNoFailure) {
  const auto faster = history::compare_runs(made_up::run(1, {.time = 1.1}), made_up::run(2));
  EXPECT_TRUE(has_change(faster, Quantity::Time, Direction::Better, "r0", ""));
  EXPECT_EQ(history::exit_status(faster), 0);
}

TEST(CompareRuns, MoreNoiseIsFoundInEachTarget) {
  const auto comparison = history::compare_runs(made_up::run(1), made_up::run(2, {.noise = 1.5}));
  EXPECT_GE(std::count_if(comparison.changes.begin(), comparison.changes.end(),
                          [](const Change& change) { return change.quantity == Quantity::Error; }),
            25);
}

TEST(CompareRuns, OneRenderThatTakesTwiceAsLongIsFound) {
  auto after = made_up::run(2);
  after.jobs[5].cost.cpu_seconds *= 2;
  const auto comparison = history::compare_runs(made_up::run(1), after);
  EXPECT_TRUE(has_change(comparison, Quantity::Time, Direction::Worse, "r0", "s5"));
}

TEST(CompareRuns, TimesOfAnotherKindOfMachineAreNotCompared) {
  auto after = made_up::run(2, {.time = 1.5});
  for (auto& job : after.jobs) job.cost.host.cpu = "another";
  const auto comparison = history::compare_runs(made_up::run(1), after);
  EXPECT_TRUE(comparison.changes.empty());
  ASSERT_EQ(comparison.notes.size(), 1U);
  EXPECT_EQ(comparison.notes[0], "times of renders of 120 not compared: another kind of machine");
}

// A verdict takes as many samples as it needs: its light is compared all the same, its noise and time are
// not.
TEST(CompareRuns, OfOtherSamplesTheLightIsCompared) {
  auto after = made_up::run(2, {.time = 2, .noise = 1.5});
  for (auto& job : after.jobs) job.identity.spp = 128;
  const auto same = history::compare_runs(made_up::run(1), after);
  EXPECT_TRUE(same.changes.empty());
  EXPECT_EQ(history::exit_status(same), 0);
  ASSERT_EQ(same.notes.size(), 2U);
  EXPECT_EQ(same.notes[0],
            "errors of 120 targets not compared, as their numbers of samples differ (r0 s0, r0 s1, r0 s2, "
            "r0 s3, r0 s4, r0 s5, r0 s6, r0 s7, ...)");
  EXPECT_EQ(same.notes[1], "times of renders of 120 not compared: other numbers of samples");
  auto darker = made_up::run(2, {.light = 0.99});
  for (auto& job : darker.jobs) job.identity.spp = 128;
  EXPECT_TRUE(has_change(history::compare_runs(made_up::run(1), darker), Quantity::Light, Direction::Worse,
                         "r0", ""));
}

TEST(CompareRuns, AnotherReferenceMakesATargetNoLongerComparable) {
  auto after = made_up::run(1);
  after.targets[3].reference_provenance["spp"] = "1024";
  const auto comparison = history::compare_runs(made_up::run(1), after);
  ASSERT_EQ(comparison.lost.size(), 1U);
  EXPECT_EQ(history::loss_name(comparison.lost[0].loss), "no longer comparable");
  EXPECT_EQ(comparison.lost[0].reason, "the reference is another one");
  EXPECT_EQ(history::exit_status(comparison), 1);
}

// As a run leaves a target that it did not reach: without samples, reference or numbers.
TEST(CompareRuns, ATargetThatAnInterruptedRunDidNotReachIsCalledSo) {
  auto before = made_up::run(1);
  for (auto& target : before.targets) target.reference_provenance["spp"] = "1024";
  auto after = before;
  after.interrupted = true;
  auto& target = after.targets[3];
  target.verdict = results::Verdict::Skipped;
  target.reference_provenance.clear();
  target.measures.clear();
  const auto comparison = history::compare_runs(before, after);
  EXPECT_TRUE(comparison.changes.empty());
  ASSERT_EQ(comparison.notes.size(), 1U);
  EXPECT_EQ(comparison.notes[0], "1 target not rendered: the run was interrupted (r0 s3)");
  EXPECT_EQ(history::exit_status(comparison), 1);
  EXPECT_NE(history::comparison_text(comparison, {false, 200}).find("0 changed otherwise, 1 not rendered"),
            std::string::npos);
  EXPECT_NE(history::comparison_json(comparison).find("\"loss\": \"not rendered\""), std::string::npos);
  const auto back = history::compare_runs(after, before);
  ASSERT_EQ(back.notes.size(), 1U);
  EXPECT_EQ(back.notes[0], "1 target not rendered: in run-1: the run was interrupted (r0 s3)");
  EXPECT_EQ(history::exit_status(back), 1);
}

// A crash has no reference record either: the verdict says all.
TEST(CompareRuns, ACrashIsWorseAndItsReferenceIsNoOther) {
  auto before = made_up::run(1);
  for (auto& target : before.targets) target.reference_provenance["spp"] = "1024";
  auto after = before;
  after.targets[3].verdict = results::Verdict::Crash;
  after.targets[3].reference_provenance.clear();
  after.targets[3].measures.clear();
  const auto comparison = history::compare_runs(before, after);
  EXPECT_EQ(comparison.changes.size(), 1U);
  EXPECT_TRUE(comparison.lost.empty());
  EXPECT_TRUE(comparison.notes.empty());
}

TEST(CompareRuns, VerdictsAreFactsAndTheWorstComesFirst) {
  auto before = made_up::run(1);
  auto after = before;
  after.targets[0].verdict = results::Verdict::Fail;
  after.targets[1].verdict = results::Verdict::Crash;
  after.targets[2].verdict = results::Verdict::Inconclusive;
  before.targets[3].verdict = results::Verdict::Fail;
  before.targets[4].verdict = results::Verdict::Skipped;
  after.targets[5].verdict = results::Verdict::Fail;
  after.targets[5].expectation = results::Expectation::Known;
  const auto comparison = history::compare_runs(before, after);
  std::vector<std::string> texts;
  for (const auto& change : comparison.changes)
    texts.push_back(history::direction_name(change.direction) + " " + change.target + " " + change.after);
  EXPECT_EQ(texts, (std::vector<std::string>{"worse s1 crash", "worse s0 fail", "worse s5 known",
                                             "changed s2 inconclusive", "better s3 pass"}));
  EXPECT_EQ(history::exit_status(comparison), 1);
}

TEST(CompareRuns, ATargetThatVanishedIsNamedAndRed) {
  auto after = made_up::run(2);
  after.targets.pop_back();
  const auto comparison = history::compare_runs(made_up::run(1), after);
  ASSERT_EQ(comparison.notes.size(), 1U);
  EXPECT_EQ(comparison.notes[0], "1 target only in run-1: r3 s29");
  EXPECT_EQ(history::exit_status(comparison), 1);
  EXPECT_NE(history::comparison_text(comparison, {false, 200}).find(", 1 vanished"), std::string::npos);
}

TEST(CompareRuns, ANewTargetIsNamedWithItsFailure) {
  auto before = made_up::run(1);
  before.targets.pop_back();
  auto after = made_up::run(2);
  after.targets.back().verdict = results::Verdict::Fail;
  const auto comparison = history::compare_runs(before, after);
  ASSERT_EQ(comparison.notes.size(), 1U);
  EXPECT_EQ(comparison.notes[0], "1 target only in run-2: r3 s29 (fail)");
  EXPECT_EQ(history::exit_status(comparison), 0);
}

// From 5.1 % too much light to 4.9 % too little.
TEST(CompareRuns, AMeanThatChangesItsSignIsNotBetter) {
  auto before = made_up::run(1);
  auto after = before;
  const auto set_light = [](results::TargetRecord& target, double light) {
    for (auto& measure : target.measures)
      if (measure.name == "mean_ratio_r") measure.value = light;
  };
  set_light(before.targets[0], 0.051);
  set_light(after.targets[0], -0.049);
  set_light(before.targets[1], 0.051);
  set_light(after.targets[1], -0.011);
  const auto comparison = history::compare_runs(before, after);
  EXPECT_TRUE(has_change(comparison, Quantity::Light, Direction::Worse, "r0", "s0"));
  EXPECT_TRUE(has_change(comparison, Quantity::Light, Direction::Neither, "r0", "s1"));
  EXPECT_EQ(history::exit_status(comparison), 1);
  const auto text = history::comparison_text(comparison, {false, 300});
  EXPECT_NE(text.find("-4.900 % (other sign)"), std::string::npos) << text;
  EXPECT_EQ(history::count_of(comparison, Direction::Better), 0U);
}

TEST(CompareRuns, AKnownFailureThatIsAnotherOneNowIsWorse) {
  auto before = made_up::run(1);
  before.targets[0].verdict = results::Verdict::Fail;
  before.targets[0].expectation = results::Expectation::Known;
  auto after = before;
  after.targets[0].verdict = results::Verdict::Crash;
  const auto comparison = history::compare_runs(before, after);
  ASSERT_EQ(comparison.changes.size(), 1U);
  EXPECT_EQ(comparison.changes[0].direction, Direction::Worse);
  EXPECT_EQ(comparison.changes[0].before, "known (fail)");
  EXPECT_EQ(comparison.changes[0].after, "known (crash)");
}

TEST(CompareRuns, RunsOfOtherSuitesAreRefused) {
  auto after = made_up::run(2);
  after.suite = "other";
  EXPECT_THROW(history::compare_runs(made_up::run(1), after), InputError);
}

TEST(CompareRuns, MarkdownEscapesWhatWouldEndACell) {
  auto before = made_up::run(1);
  auto after = before;
  after.targets[0].verdict = results::Verdict::Fail;
  after.targets[0].reason = "a | b <script>";
  const auto text = history::comparison_markdown(history::compare_runs(before, after));
  EXPECT_NE(text.find("**1 worse, 0 better, 0 changed otherwise**"), std::string::npos) << text;
  EXPECT_NE(text.find("| worse | r0 | M1 | s0 | verdict | pass | fail |  | a \\| b \\<script> |"),
            std::string::npos)
      << text;
}

TEST(CompareRuns, TheTextStaysWithinTheTerminalAndWorseIsRed) {
  auto before = made_up::run(1);
  auto after = before;
  after.targets[0].verdict = results::Verdict::Fail;
  after.targets[0].reason = "the mean over the block [12,14,76,78] is off by 4.9 % or more for certain";
  const auto comparison = history::compare_runs(before, after);
  const auto text = history::comparison_text(comparison, {true, 80});
  for (const auto& line : split(text, '\n')) EXPECT_LE(display_width(line), 80U) << line;
  EXPECT_NE(text.find("\x1b[31mworse\x1b[0m"), std::string::npos) << text;
  EXPECT_EQ(history::comparison_text(comparison, {false, 80}).find('\x1b'), std::string::npos);
}
