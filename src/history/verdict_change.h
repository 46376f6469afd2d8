#pragma once

#include "results/verdict.h"

#include <array>
#include <cstddef>
#include <string_view>

namespace orbs::history {

/// What it means that a target has one state in a run and another one in a later run.
enum class VerdictChange { Same, Better, Neither, Worse, NotRendered };

struct State {
  results::Verdict verdict = results::Verdict::Skipped;
  results::Expectation expectation = results::Expectation::None;
};

namespace verdict_change_table {

/// The rows and columns of the table. Failure: every verdict from fail to crash.
enum Group : std::size_t {
  Pass,
  PassWithRemarks,
  UnexpectedPass,
  Unsupported,
  Skipped,
  Inconclusive,
  MissingReference,
  Failure,
  KnownInconclusive,
  KnownFailure
};

constexpr Group group_of(State state) {
  using results::Expectation;
  using results::VerdictKind;
  const bool is_known = state.expectation == Expectation::Known;
  switch (results::kind_of(state.verdict)) {
    case VerdictKind::Pass:
      if (state.verdict == results::Verdict::PassWithRemarks) return PassWithRemarks;
      return state.expectation == Expectation::News ? UnexpectedPass : Pass;
    case VerdictKind::Unsupported:
      return Unsupported;
    case VerdictKind::Skipped:
      return Skipped;
    case VerdictKind::Inconclusive:
      return is_known ? KnownInconclusive : Inconclusive;
    case VerdictKind::MissingReference:
      return MissingReference;
    case VerdictKind::WrongImage:
    case VerdictKind::NoImage:
      return is_known ? KnownFailure : Failure;
  }
  return Failure;
}

/// A row for the state before, a column for the state after, in the order of Group.
///   =  the same
///   +  better: it passes now, or has no remarks any more
///   -  worse: it counts as a failure and did not before, or is known to fail and passed before, or has
///      remarks now, or nothing is said of it any more (unsupported, missing reference)
///   ~  neither: noise decides between pass and inconclusive; a failure that was accepted is the same image;
///      whether a pass is unexpected says the configuration
///   v  by the order of the verdicts, the later the worse; of one verdict, ~ where it was accepted
///   0  not rendered in one of the runs: nothing can be said
inline constexpr std::array<std::string_view, 10> kTable{
    "=-~-0~----",  // pass
    "+=~-0~----",  // pass with remarks
    "~-=-0~----",  // unexpected pass
    "+++=0---~~",  // unsupported
    "0000000000",  // skipped
    "~~~-0=--~-",  // inconclusive
    "+++-0~=-~~",  // missing reference
    "+++-0~-v~v",  // failure
    "+++-0---=-",  // known, inconclusive
    "+++-0---~v",  // known failure
};

}  // namespace verdict_change_table

constexpr VerdictChange verdict_change(State before, State after) {
  using namespace verdict_change_table;
  switch (kTable.at(group_of(before)).at(group_of(after))) {
    case '=':
      return VerdictChange::Same;
    case '+':
      return VerdictChange::Better;
    case '-':
      return VerdictChange::Worse;
    case '~':
      return VerdictChange::Neither;
    case 'v':
      if (after.verdict > before.verdict) return VerdictChange::Worse;
      if (after.verdict < before.verdict) return VerdictChange::Better;
      return group_of(before) == group_of(after) ? VerdictChange::Same : VerdictChange::Neither;
    default:
      return VerdictChange::NotRendered;
  }
}

}  // namespace orbs::history
