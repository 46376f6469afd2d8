#pragma once

#include "results/verdict.h"

#include <array>
#include <optional>
#include <string_view>

namespace orbs::results {

/// What became of a render. Whether its image is right is another question: see Verdict.
enum class JobOutcome {
  Image,          // the renderer left a usable image
  Unsupported,    // the scene cannot be prepared for the renderer
  Skipped,        // the run ended before the render's turn
  InvalidPixels,  // NaN, infinite, or negative where no case allows it
  WrongChannels,  // R, G or B is missing
  WrongSize,      // another width or height than the scene's
  Stale,          // the image is older than its render, or of another scene or render
  Unreadable,     // the file cannot be read as an image
  NoOutput,       // the renderer ended well but left no image
  Timeout,        // the limit of wall-clock or processor time ended it
  OutOfMemory,    // the memory limit ended it
  Crash,          // could not start, was killed by a signal, or ended with an exit code
};

inline constexpr std::array kJobOutcomes{
    JobOutcome::Image,         JobOutcome::Unsupported, JobOutcome::Skipped,     JobOutcome::InvalidPixels,
    JobOutcome::WrongChannels, JobOutcome::WrongSize,   JobOutcome::Stale,       JobOutcome::Unreadable,
    JobOutcome::NoOutput,      JobOutcome::Timeout,     JobOutcome::OutOfMemory, JobOutcome::Crash};

/// The verdict on a target whose render ended so. None for a usable image: the judge has to look at it.
std::optional<Verdict> verdict_without_image(JobOutcome outcome);

/// "image", else the name of the verdict that the outcome means: "no output", ...
std::string_view job_outcome_name(JobOutcome outcome);

/// The outcome of that name, if there is one.
std::optional<JobOutcome> job_outcome_named(std::string_view name);

/// As fields() write and read it. InputError for an unknown name.
inline std::string_view to_text(JobOutcome value) { return job_outcome_name(value); }
void from_text(std::string_view name, JobOutcome& value);

/// True where the renderer left a file that can be looked at even if it cannot be judged.
bool leaves_visible_image(JobOutcome outcome);

}  // namespace orbs::results
