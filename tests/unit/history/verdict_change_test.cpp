// What every pair of states of two runs means.
#include "history/verdict_change.h"

#include <array>
#include <map>
#include <string>
#include <vector>

#include <gtest/gtest.h>

using namespace orbs;
using history::State;
using history::VerdictChange;
using results::Expectation;
using results::Verdict;

namespace {

char letter_of(VerdictChange change) {
  switch (change) {
    case VerdictChange::Same:
      return '.';
    case VerdictChange::Better:
      return 'B';
    case VerdictChange::Neither:
      return 'n';
    case VerdictChange::Worse:
      return 'W';
    case VerdictChange::NotRendered:
      return '0';
  }
  return ' ';
}

// Every state that a target can have: the verdicts, an unexpected pass, and the known failures.
std::vector<State> all_states() {
  std::vector<State> states;
  for (const auto verdict : results::kVerdicts) states.push_back({verdict, Expectation::None});
  states.push_back({Verdict::Pass, Expectation::News});
  for (const auto verdict : results::kVerdicts)
    if (results::counts_as_failure(verdict) && verdict != Verdict::Skipped &&
        verdict != Verdict::MissingReference)
      states.push_back({verdict, Expectation::Known});
  return states;
}

std::string name_of(State state) {
  auto name = std::string(results::state_name(state.verdict, state.expectation));
  return state.expectation == Expectation::Known ? name + " " + std::string(verdict_name(state.verdict))
                                                 : name;
}

bool counts(State state) { return results::counts_as_failure(state.verdict, state.expectation); }

// One letter for each state after, in the order of all_states():
// pass, pass with remarks, unsupported, skipped, inconclusive, missing reference; fail to crash; unexpected
// pass; known: inconclusive, fail to crash.
const std::map<std::string, std::string> kExpected{{"pass", ".WW0nWWWWWWWWWWWWnWWWWWWWWWWWW"},
                                                   {"pass with remarks", "B.W0nWWWWWWWWWWWWnWWWWWWWWWWWW"},
                                                   {"unsupported", "BB.0WWWWWWWWWWWWWBnnnnnnnnnnnn"},
                                                   {"skipped", "000000000000000000000000000000"},
                                                   {"inconclusive", "nnW0.WWWWWWWWWWWWnnWWWWWWWWWWW"},
                                                   {"missing reference", "BBW0n.WWWWWWWWWWWBnnnnnnnnnnnn"},
                                                   {"fail", "BBW0nW.WWWWWWWWWWBnnWWWWWWWWWW"},
                                                   {"constant image", "BBW0nWB.WWWWWWWWWBnBnWWWWWWWWW"},
                                                   {"invalid pixels", "BBW0nWBB.WWWWWWWWBnBBnWWWWWWWW"},
                                                   {"wrong channels", "BBW0nWBBB.WWWWWWWBnBBBnWWWWWWW"},
                                                   {"wrong size", "BBW0nWBBBB.WWWWWWBnBBBBnWWWWWW"},
                                                   {"stale", "BBW0nWBBBBB.WWWWWBnBBBBBnWWWWW"},
                                                   {"unreadable", "BBW0nWBBBBBB.WWWWBnBBBBBBnWWWW"},
                                                   {"no output", "BBW0nWBBBBBBB.WWWBnBBBBBBBnWWW"},
                                                   {"timeout", "BBW0nWBBBBBBBB.WWBnBBBBBBBBnWW"},
                                                   {"out of memory", "BBW0nWBBBBBBBBB.WBnBBBBBBBBBnW"},
                                                   {"crash", "BBW0nWBBBBBBBBBB.BnBBBBBBBBBBn"},
                                                   {"unexpected pass", "nWW0nWWWWWWWWWWWW.WWWWWWWWWWWW"},
                                                   {"known inconclusive", "BBW0WWWWWWWWWWWWWB.WWWWWWWWWWW"},
                                                   {"known fail", "BBW0WWWWWWWWWWWWWBn.WWWWWWWWWW"},
                                                   {"known constant image", "BBW0WWWWWWWWWWWWWBnB.WWWWWWWWW"},
                                                   {"known invalid pixels", "BBW0WWWWWWWWWWWWWBnBB.WWWWWWWW"},
                                                   {"known wrong channels", "BBW0WWWWWWWWWWWWWBnBBB.WWWWWWW"},
                                                   {"known wrong size", "BBW0WWWWWWWWWWWWWBnBBBB.WWWWWW"},
                                                   {"known stale", "BBW0WWWWWWWWWWWWWBnBBBBB.WWWWW"},
                                                   {"known unreadable", "BBW0WWWWWWWWWWWWWBnBBBBBB.WWWW"},
                                                   {"known no output", "BBW0WWWWWWWWWWWWWBnBBBBBBB.WWW"},
                                                   {"known timeout", "BBW0WWWWWWWWWWWWWBnBBBBBBBB.WW"},
                                                   {"known out of memory", "BBW0WWWWWWWWWWWWWBnBBBBBBBBB.W"},
                                                   {"known crash", "BBW0WWWWWWWWWWWWWBnBBBBBBBBBB."}};

}  // namespace

TEST(VerdictChange, OfEveryPairIsAsListed) {
  const auto states = all_states();
  ASSERT_EQ(states.size(), kExpected.size());
  for (const auto before : states) {
    std::string row;
    for (const auto after : states) row += letter_of(history::verdict_change(before, after));
    const auto listed = kExpected.find(name_of(before));
    ASSERT_NE(listed, kExpected.end()) << name_of(before);
    EXPECT_EQ(row, listed->second) << name_of(before);
  }
}

// What an expectation adds to a failure that is news changes nothing.
TEST(VerdictChange, AFailureThatIsNewsIsAFailure) {
  for (const auto before : all_states())
    for (const auto verdict : results::kVerdicts) {
      if (verdict == Verdict::Pass) continue;
      EXPECT_EQ(history::verdict_change(before, {verdict, Expectation::News}),
                history::verdict_change(before, {verdict, Expectation::None}));
    }
}

TEST(VerdictChange, NothingThatStartsToCountAsAFailureIsBetterOrTheSame) {
  for (const auto before : all_states())
    for (const auto after : all_states()) {
      const auto change = history::verdict_change(before, after);
      const auto names = name_of(before) + " -> " + name_of(after);
      const bool is_by_noise = results::passes(before.verdict) &&
                               (after.verdict == Verdict::Inconclusive || after.verdict == Verdict::Pass);
      const bool is_better = change == VerdictChange::Better;
      const bool has_passed = is_better && results::passes(after.verdict);
      const bool is_news = !counts(before) && counts(after) && !is_by_noise && !has_passed;
      EXPECT_FALSE(is_news && change != VerdictChange::Worse && change != VerdictChange::NotRendered)
          << names;
      EXPECT_FALSE(is_better && history::verdict_change(after, before) == VerdictChange::Better) << names;
    }
}
