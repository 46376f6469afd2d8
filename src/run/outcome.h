#pragma once

#include "adapters/job.h"
#include "adapters/process/process.h"
#include "image/image.h"
#include "results/job_outcome.h"

#include <optional>
#include <string>

namespace orbs::run {

/// How a render ended, why, and the image if there is a usable one, its colour in R, G and B whatever its
/// file calls them.
struct Outcome {
  results::JobOutcome kind = results::JobOutcome::Image;
  std::string reason;
  std::optional<image::Image> image;
  bool is_as_written = true;  // false: its file has other names for its channels, or more of them
};

/// The first of these that applies, in this fixed order: could not start, ended by us (a limit, an
/// interrupt), signal, exit code, a line of output that its entry calls a failure, no output, stale,
/// unreadable, of another scene or job, wrong size, wrong channels, invalid pixels. A reason about the
/// process ends with the line of its output that says most about why.
Outcome classify(const adapters::ProcessResult& process,
                 const adapters::Job& job,
                 const ProcessLimits& limits);

/// The part of classify that checks the pixels: size, channels, values. JobOutcome::Image, but without the
/// image itself, if all are usable. `name` is what the reason calls the image.
Outcome check_pixels(const adapters::Job& job, const image::Image& image, const std::string& name);

}  // namespace orbs::run
