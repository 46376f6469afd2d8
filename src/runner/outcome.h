#pragma once

#include "adapters/job.h"
#include "adapters/process.h"
#include "image/image.h"
#include "results/verdict.h"

#include <optional>
#include <string>

namespace orbs::runner {

/// How a render ended: Pass when there is a usable picture (whether it is right is another question).
struct Outcome {
  results::Verdict verdict = results::Verdict::Pass;
  std::string sentence;
  std::optional<image::Image> picture;  // with Pass
};

/// Asks in this fixed order, and the first that applies is the answer: could not start, timeout, signal, exit
/// code, no output, unreadable, wrong size, wrong channels, invalid pixels.
Outcome classify(const adapters::ProcessResult& process, const adapters::Job& job, double time_limit_seconds);

}  // namespace orbs::runner
