#include "results/verdict.h"

#include "base/error.h"

#include <algorithm>

#include <fmt/format.h>

namespace orbs::results {

std::string_view verdict_name(Verdict verdict) {
  switch (verdict) {
    case Verdict::Pass:
      return "pass";
    case Verdict::PassWithRemarks:
      return "pass with remarks";
    case Verdict::Unsupported:
      return "unsupported";
    case Verdict::Skipped:
      return "skipped";
    case Verdict::Inconclusive:
      return "inconclusive";
    case Verdict::MissingReference:
      return "missing reference";
    case Verdict::Fail:
      return "fail";
    case Verdict::ConstantImage:
      return "constant image";
    case Verdict::InvalidPixels:
      return "invalid pixels";
    case Verdict::WrongChannels:
      return "wrong channels";
    case Verdict::WrongSize:
      return "wrong size";
    case Verdict::Stale:
      return "stale";
    case Verdict::Unreadable:
      return "unreadable";
    case Verdict::NoOutput:
      return "no output";
    case Verdict::Timeout:
      return "timeout";
    case Verdict::OutOfMemory:
      return "out of memory";
    case Verdict::Crash:
      return "crash";
  }
  return {};
}

std::optional<Verdict> verdict_named(std::string_view name) {
  for (const auto verdict : kVerdicts)
    if (verdict_name(verdict) == name) return verdict;
  return std::nullopt;
}

void from_text(std::string_view name, Verdict& value) {
  const auto found = verdict_named(name);
  if (!found) throw InputError(fmt::format("'{}' is no verdict that this version of orbs knows", name));
  value = *found;
}

Verdict worse(Verdict a, Verdict b) { return std::max(a, b); }

bool is_decided(Verdict verdict) {
  return verdict != Verdict::Skipped && verdict != Verdict::Inconclusive &&
         verdict != Verdict::MissingReference;
}

bool counts_as_failure(Verdict verdict) { return !passes(verdict) && verdict != Verdict::Unsupported; }

std::string_view expectation_name(Expectation expectation) {
  switch (expectation) {
    case Expectation::None:
      return "none";
    case Expectation::Known:
      return kKnown;
    case Expectation::News:
      return "news";
  }
  return {};
}

std::optional<Expectation> expectation_named(std::string_view name) {
  for (const auto expectation : kExpectations)
    if (expectation_name(expectation) == name) return expectation;
  return std::nullopt;
}

void from_text(std::string_view name, Expectation& value) {
  const auto found = expectation_named(name);
  if (!found) throw InputError(fmt::format("'{}' is no expectation that this version of orbs knows", name));
  value = *found;
}

std::string_view state_name(Verdict verdict, Expectation expectation) {
  if (expectation == Expectation::Known) return kKnown;
  if (expectation == Expectation::News && verdict == Verdict::Pass) return kUnexpectedPass;
  return verdict_name(verdict);
}

bool counts_as_failure(Verdict verdict, Expectation expectation) {
  if (expectation == Expectation::None) return counts_as_failure(verdict);
  return expectation == Expectation::News;
}

namespace {

// Places in the order of states; there is room between two verdicts.
int badness(Verdict verdict, Expectation expectation) {
  const auto place = [](Verdict of) { return 2 * static_cast<int>(of); };
  if (expectation == Expectation::Known) return place(Verdict::Unsupported) + 1;
  if (state_name(verdict, expectation) == kUnexpectedPass) return place(Verdict::Skipped) + 1;
  return place(verdict);
}

}  // namespace

bool is_worse(Verdict verdict, Expectation expectation, Verdict than, Expectation than_expectation) {
  return badness(verdict, expectation) > badness(than, than_expectation);
}

}  // namespace orbs::results
