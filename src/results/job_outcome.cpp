#include "results/job_outcome.h"

#include "base/error.h"

#include <fmt/format.h>

namespace orbs::results {

std::optional<Verdict> verdict_without_image(JobOutcome outcome) {
  switch (outcome) {
    case JobOutcome::Image:
      return std::nullopt;
    case JobOutcome::Unsupported:
      return Verdict::Unsupported;
    case JobOutcome::Skipped:
      return Verdict::Skipped;
    case JobOutcome::InvalidPixels:
      return Verdict::InvalidPixels;
    case JobOutcome::WrongChannels:
      return Verdict::WrongChannels;
    case JobOutcome::WrongSize:
      return Verdict::WrongSize;
    case JobOutcome::Stale:
      return Verdict::Stale;
    case JobOutcome::Unreadable:
      return Verdict::Unreadable;
    case JobOutcome::NoOutput:
      return Verdict::NoOutput;
    case JobOutcome::Timeout:
      return Verdict::Timeout;
    case JobOutcome::OutOfMemory:
      return Verdict::OutOfMemory;
    case JobOutcome::Crash:
      return Verdict::Crash;
  }
  return std::nullopt;
}

std::string_view job_outcome_name(JobOutcome outcome) {
  const auto verdict = verdict_without_image(outcome);
  return verdict ? verdict_name(*verdict) : "image";
}

std::optional<JobOutcome> job_outcome_named(std::string_view name) {
  for (const auto outcome : kJobOutcomes)
    if (job_outcome_name(outcome) == name) return outcome;
  return std::nullopt;
}

void from_text(std::string_view name, JobOutcome& value) {
  const auto found = job_outcome_named(name);
  if (!found) throw InputError(fmt::format("'{}' is no outcome that this version of orbs knows", name));
  value = *found;
}

bool leaves_visible_image(JobOutcome outcome) {
  switch (outcome) {
    case JobOutcome::Image:
    case JobOutcome::InvalidPixels:
    case JobOutcome::WrongSize:
    case JobOutcome::Stale:
      return true;
    case JobOutcome::Unsupported:
    case JobOutcome::Skipped:
    case JobOutcome::WrongChannels:
    case JobOutcome::Unreadable:
    case JobOutcome::NoOutput:
    case JobOutcome::Timeout:
    case JobOutcome::OutOfMemory:
    case JobOutcome::Crash:
      return false;
  }
  return false;
}

}  // namespace orbs::results
