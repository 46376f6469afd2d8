#pragma once

#include "adapters/job.h"
#include "adapters/process.h"
#include "image/image.h"
#include "results/verdict.h"

#include <optional>
#include <string>

namespace orbs::runner {

/// How a render ended: Pass when there is a usable image, which says nothing about its being right.
struct Outcome {
  results::Verdict verdict = results::Verdict::Pass;
  std::string reason;
  std::optional<image::Image> image;  // with Pass
};

/// The first of these that applies, in this fixed order: could not start, ended by us (a limit, an
/// interrupt), signal, exit code, no output, stale, unreadable, of another scene or job, wrong size, wrong
/// channels, invalid pixels. A reason about the process ends with the last line of its output.
Outcome classify(const adapters::ProcessResult& process,
                 const adapters::Job& job,
                 const supervisor::Limits& limits);

/// The part of classify that is about the pixels: size, channels, values. Pass, without the image, when all
/// are usable. The reason calls the image `name`.
Outcome check_pixels(const adapters::Job& job, const image::Image& image, const std::string& name);

}  // namespace orbs::runner
