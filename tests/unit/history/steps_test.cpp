// Steps over many runs: what is found, and how often something is found where nothing is.
#include "history/steps.h"

#include "base/error.h"
#include "base/text.h"
#include "base/text_table.h"
#include "history/history_text.h"
#include "report/history_page.h"
#include "unit/history/made_up_run.h"

#include <algorithm>

#include <gtest/gtest.h>

using namespace orbs;
using history::Change;
using history::Quantity;

namespace {

// Runs with consecutive seeds and dates; those from `changed` on have other settings.
history::History history_of(int runs,
                            int changed,
                            const made_up::Settings& settings,
                            std::uint64_t seed = 0) {
  std::vector<results::RunRecord> records;
  for (int i = 0; i < runs; ++i) {
    records.push_back(made_up::run(seed + static_cast<std::uint64_t>(i) + 1,
                                   i >= changed ? settings : made_up::Settings{}));
    records.back().started = fmt::format("2026-01-{:02}T00:00:00", i + 1);
  }
  return history::make_history(std::move(records));
}

const Change* find(const std::vector<Change>& steps, Quantity quantity, const std::string& target) {
  const auto found = std::find_if(steps.begin(), steps.end(), [&](const Change& step) {
    return step.quantity == quantity && step.renderer == "r0" && step.target == target;
  });
  return found == steps.end() ? nullptr : &*found;
}

}  // namespace

TEST(BestSplit, FindsThePlaceAndCountsItsPlaces) {
  const auto split = history::best_split({{0, 1, 2, 3, 4, 5}, {1, 1.1, 0.9, 2, 2.1, 1.9}});
  EXPECT_EQ(split.at, 3U);
  EXPECT_DOUBLE_EQ(split.before, 1);
  EXPECT_DOUBLE_EQ(split.after, 2);
  // t = 1 / (0.1 sqrt(2 / 3)) = 12.25 of 4 degrees of freedom: 2.55e-4, at 5 places.
  EXPECT_NEAR(split.probability, 5 * 2.55e-4, 2e-5);
  EXPECT_EQ(history::best_split({{0, 1, 2}, {1, 1, 1}}).probability, 1);
}

// The stated rate is 1 in 100. Of 100 histories 5 or more then have a step with a probability of 0.4 %.
TEST(Steps, AreFoundNoMoreOftenThanStatedInRunsOfEqualPrograms) {
  int alarms = 0;
  for (std::uint64_t i = 0; i < 100; ++i)
    if (!history::find_steps(history_of(12, 12, {}, 1000 * i)).empty()) ++alarms;
  EXPECT_LE(alarms, 4);
}

TEST(Steps, OnePercentLessLightIsFoundWithTheRunSinceWhichItIsThere) {
  const auto steps = history::find_steps(history_of(12, 8, {.light = 0.99}));
  const auto* step = find(steps, Quantity::Light, "");
  ASSERT_NE(step, nullptr);
  EXPECT_EQ(step->direction, history::Direction::Worse);
  EXPECT_EQ(step->since, "run-9 (2026-01-09T00:00:00)");
}

TEST(Steps, TenPercentMoreTimeIsFound) {
  const auto steps = history::find_steps(history_of(12, 8, {.time = 1.1}));
  const auto* step = find(steps, Quantity::Time, "");
  ASSERT_NE(step, nullptr);
  EXPECT_EQ(step->since, "run-9 (2026-01-09T00:00:00)");
  for (const auto& other : steps) EXPECT_EQ(other.renderer, "r0");
}

TEST(Steps, NeedFiveRuns) {
  EXPECT_TRUE(history::find_steps(history_of(4, 2, {.time = 2})).empty());
  EXPECT_FALSE(history::find_steps(history_of(5, 3, {.time = 2})).empty());
}

TEST(History, TimesOfOtherMachinesAndRunsOfOtherSuitesAreLeftOut) {
  auto other_machine = made_up::run(1);
  for (auto& job : other_machine.jobs) job.cost.host.cpu = "another";
  other_machine.host.cpu = "another";
  auto other_suite = made_up::run(2);
  other_suite.suite = "another";
  const auto history = history::make_history({other_machine, other_suite, made_up::run(3)});
  EXPECT_EQ(history.runs.size(), 2U);
  ASSERT_EQ(history.notes.size(), 2U);
  EXPECT_FALSE(history.series[0].points[0].cpu_seconds);
  EXPECT_TRUE(history.series[0].points[1].cpu_seconds);
  EXPECT_THROW(history::make_history({}), InputError);
}

TEST(History, ATargetWhoseVerdictDiffersBetweenSeedsIsFlaky) {
  auto runs = std::vector{made_up::run(1), made_up::run(2), made_up::run(3)};
  runs[1].targets[4].verdict = results::Verdict::Inconclusive;
  // Another program may well have another verdict.
  runs[2].targets[5].verdict = results::Verdict::Fail;
  runs[2].jobs[5].hashes.program = "new";
  EXPECT_EQ(history::flaky_targets(history::make_history(runs)), (std::vector<std::string>{"r0 s4"}));
}

TEST(History, IsShownAsTextMarkdownAndPage) {
  const auto history = history_of(6, 3, {.renderers = 1, .targets = 4, .time = 2});
  const auto steps = history::find_steps(history);
  const auto text = history::history_text(history, steps, {});
  EXPECT_NE(text.find("6 runs of suite made-up at size 1, 2026-01-01T00:00:00 to 2026-01-06T00:00:00"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("run-4 (2026-01-04T00:00:00)"), std::string::npos) << text;
  EXPECT_NE(history::history_markdown(history, steps).find("| M1 | r0 | s0 | pass | "), std::string::npos);
  const auto page = report::history_page(history, steps);
  EXPECT_NE(page.find("<circle"), std::string::npos);
  EXPECT_EQ(page.find("<script"), std::string::npos);
}

TEST(History, StaysWithinTheTerminalAndHasTheColoursOfItsVerdicts) {
  const auto history = history_of(6, 3, {.renderers = 1, .targets = 4, .time = 2});
  const auto steps = history::find_steps(history);
  ASSERT_FALSE(steps.empty());
  const auto text = history::history_text(history, steps, {true, 80});
  for (const auto& line : split(text, '\n')) EXPECT_LE(display_width(line), 80U) << line;
  EXPECT_NE(text.find("\x1b[31mworse\x1b[0m"), std::string::npos) << text;
  EXPECT_NE(text.find("\x1b[32mpass\x1b[0m"), std::string::npos) << text;
  const auto narrow = history::history_text(history, steps, {true, 60});
  for (const auto& line : split(narrow, '\n')) EXPECT_LE(display_width(line), 60U) << line;
  EXPECT_NE(narrow.find("\x1b[32mpass 6\x1b[0m"), std::string::npos) << narrow;
  EXPECT_EQ(history::history_text(history, steps, {false, 80}).find('\x1b'), std::string::npos);
}
