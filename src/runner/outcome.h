#pragma once

#include "adapters/job.h"
#include "adapters/process/process.h"
#include "image/image.h"
#include "results/verdict.h"

#include <optional>
#include <string>

namespace orbs::runner {

/// How a render ended: Pass when there is a usable image (whether it is right is another question).
struct Outcome {
  results::Verdict verdict = results::Verdict::Pass;
  std::string reason;
  std::optional<image::Image> image;  // with Pass
};

/// Asks in this fixed order, and the first that applies is the answer: could not start, ended by us (a limit,
/// an interrupt), signal, exit code, no output, stale, unreadable, of another scene or job, wrong size, wrong
/// channels, invalid pixels. A reason about the process ends with its last words.
Outcome classify(const adapters::ProcessResult& process,
                 const adapters::Job& job,
                 const ProcessLimits& limits);

/// The part of this that is about the pixels: size, channels, values. Pass without the image when all are
/// usable. `name` is the image's in the reason.
Outcome check_pixels(const adapters::Job& job, const image::Image& image, const std::string& name);

}  // namespace orbs::runner
