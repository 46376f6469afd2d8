#include "runner/outcome.h"

#include "base/error.h"
#include "image/image_io.h"
#include "metrics/alignment.h"

#include <filesystem>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace orbs::runner {

namespace {

using results::Verdict;

Outcome process_outcome(const adapters::ProcessResult& process, double time_limit_seconds) {
  if (!process.start_error.empty())
    return {Verdict::Crash, fmt::format("could not start: {}", process.start_error), {}};
  if (process.timed_out)
    return {Verdict::Timeout, fmt::format("was ended after its time limit of {} s", time_limit_seconds), {}};
  if (process.stopped) return {Verdict::Skipped, "was ended because the run was interrupted", {}};
  if (process.signal != 0)
    return {Verdict::Crash, fmt::format("was killed by {}", adapters::signal_name(process.signal)), {}};
  if (process.exit_code != 0)
    return {Verdict::Crash, fmt::format("ended with exit code {}", process.exit_code), {}};
  return {};
}

Outcome picture_outcome(const adapters::Job& job) {
  const auto name = job.image.filename().string();
  std::error_code ignored;
  if (!std::filesystem::exists(job.image, ignored))
    return {Verdict::NoOutput, fmt::format("wrote no {}", name), {}};
  image::Image picture;
  try {
    picture = image::read_image(job.image);
  } catch (const InputError& e) {
    return {Verdict::NoOutput, e.what(), {}};
  }
  if (picture.width != job.width_px || picture.height != job.height_px)
    return {Verdict::WrongSize,
            fmt::format("{} is {} x {} pixels, expected {} x {}", name, picture.width, picture.height,
                        job.width_px, job.height_px),
            {}};
  for (const char* channel : {"R", "G", "B"})
    if (image::channel_index(picture, channel) < 0)
      return {
          Verdict::WrongSize,
          fmt::format("{} has the channels {}, expected R, G, B", name, fmt::join(picture.channels, ", ")),
          {}};
  const auto faults = metrics::check_alignment(picture, picture).result;
  if (!faults.first.empty())
    return {Verdict::InvalidPixels,
            fmt::format("{} pixels are NaN, {} infinite, {} negative; the first is {}", faults.nan,
                        faults.infinite, faults.negative, faults.first),
            {}};
  return {Verdict::Pass, "", std::move(picture)};
}

}  // namespace

Outcome classify(const adapters::ProcessResult& process,
                 const adapters::Job& job,
                 double time_limit_seconds) {
  auto outcome = process_outcome(process, time_limit_seconds);
  return outcome.verdict == Verdict::Pass ? picture_outcome(job) : outcome;
}

}  // namespace orbs::runner
