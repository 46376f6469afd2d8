#include "run/outcome.h"

#include "base/error.h"
#include "base/pattern.h"
#include "base/text.h"
#include "image/image_io.h"
#include "metrics/alignment.h"
#include "run/job_folder.h"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sys/stat.h>

namespace orbs::run {

namespace {

namespace fs = std::filesystem;
using results::JobOutcome;
using supervisor::Cause;

// ESC [ ... and a last byte from @ to ~ (ECMA-48, 5.4), which set colours.
std::string without_escapes(const std::string& text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool is_sequence = text[i] == '\x1b' && i + 1 < text.size() && text[i + 1] == '[';
    if (!is_sequence) {
      out += text[i];
      continue;
    }
    i += 2;
    while (i < text.size() && (text[i] < '@' || text[i] > '~')) ++i;
  }
  return out;
}

// A carriage return starts a line anew.
std::vector<std::string> lines_with_text(const std::string& output) {
  std::vector<std::string> lines;
  for (const auto& line : split(output, '\n'))
    for (const auto& part : split(without_escapes(line), '\r'))
      if (const auto text = trim(part); !text.empty()) lines.emplace_back(text);
  return lines;
}

bool names_error(const std::string& line) {
  static const Pattern kError("([Ee]rror|ERROR|[Ee]xception|[Ff]atal|FATAL)[^:]*: *[^ ]");
  return !kError.last_match(line).empty();
}

// At most `most` bytes, no character cut in two.
std::string shortened(std::string text, std::size_t most) {
  if (text.size() <= most) return text;
  while (most > 0 && (static_cast<unsigned char>(text[most]) & 0xc0U) == 0x80U) --most;
  text.resize(most);
  return text;
}

// The line of a failed renderer's output that says most about why: of the last lines that are not empty the
// first that names an error ("Error: ...", "ValueError: ..."), since later ones often are what follows from
// it; else the last line. "" for an output without text.
std::string last_words(const std::string& output, const std::filesystem::path& folder) {
  constexpr std::size_t kMost_bytes = 200;
  constexpr std::ptrdiff_t kLastLines = 12;
  const auto lines = lines_with_text(output);
  if (lines.empty()) return "";
  const auto last = lines.end() - std::min<std::ptrdiff_t>(kLastLines, std::ssize(lines));
  const auto error = std::find_if(last, lines.end(), names_error);
  return shortened(clean_text(named_within(folder, error == lines.end() ? lines.back() : *error)),
                   kMost_bytes);
}

std::string megabytes(std::size_t bytes) {
  return fmt::format("{:.6g} MB", static_cast<double>(bytes) / (1 << 20));
}

Outcome limit_outcome(Cause cause, const ProcessLimits& limits) {
  switch (cause) {
    case Cause::Nothing:
      break;
    case Cause::WallTime:
      return {JobOutcome::Timeout,
              fmt::format("was ended after its time limit of {} s", limits.wall_seconds),
              {}};
    case Cause::CpuTime:
      return {
          JobOutcome::Timeout,
          fmt::format("was ended after {} s of processor time, its limit", limits.cpu_seconds.value_or(0)),
          {}};
    case Cause::Memory:
      return {JobOutcome::OutOfMemory,
              fmt::format("was ended because it took more than its {} of memory",
                          megabytes(limits.memory_bytes.value_or(0))),
              {}};
    case Cause::Output:
      return {JobOutcome::Crash,
              fmt::format("was ended because it wrote more than its {} of files",
                          megabytes(limits.output_bytes.value_or(0))),
              {}};
    case Cause::Stopped:
      return {JobOutcome::Skipped, "was ended because the run was interrupted", {}};
  }
  return {};
}

std::string signal_message(const adapters::ProcessResult& process, const ProcessLimits& limits) {
  auto text = fmt::format("was killed by {}{}", adapters::signal_name(process.signal),
                          process.core_dumped ? " (core dumped)" : "");
  if (process.signal == SIGKILL) text += ", not by orbs: the kernel does that when memory runs out";
  if (process.signal == SIGXFSZ && limits.output_bytes)
    text += fmt::format(", which the kernel sends when a file outgrows {}; its folder holds less",
                        megabytes(*limits.output_bytes));
  return text;
}

// A shell, and bubblewrap, ends with 128 and the signal that has ended its command.
std::string exit_message(int code) {
  constexpr int kShell = 128;
  const bool is_signal = code > kShell && code < kShell + SIGRTMIN;
  return fmt::format("ended with exit code {}{}", code,
                     is_signal ? fmt::format(", as after {}", adapters::signal_name(code - kShell)) : "");
}

// The first line of the output that says that the render has failed; "" where none does.
std::string failing_line(const std::string& output, const adapters::Job& job) {
  constexpr std::size_t kMost_bytes = 200;
  for (const auto& text : job.fails_on) {
    const Pattern pattern(text);
    for (const auto& line : lines_with_text(output))
      if (pattern.matches(line)) return shortened(clean_text(named_within(job.folder, line)), kMost_bytes);
  }
  return "";
}

Outcome process_outcome(const adapters::ProcessResult& process,
                        const adapters::Job& job,
                        const ProcessLimits& limits) {
  if (!process.start_error.empty())
    return {JobOutcome::Crash, fmt::format("could not start: {}", process.start_error), {}};
  if (!process.orphaned.empty() && process.cause != Cause::Stopped)
    return {JobOutcome::Crash, fmt::format("was lost: {}", process.orphaned), {}};
  auto outcome = limit_outcome(process.cause, limits);
  if (process.cause == Cause::Nothing && process.signal != 0)
    outcome = {JobOutcome::Crash, signal_message(process, limits), {}};
  if (process.cause == Cause::Nothing && process.signal == 0 && process.exit_code != 0)
    outcome = {JobOutcome::Crash, exit_message(process.exit_code), {}};
  if (outcome.kind != JobOutcome::Image && outcome.kind != JobOutcome::Skipped)
    if (const auto words = last_words(process.output, job.folder); !words.empty())
      outcome.reason += fmt::format("; its last words: {}", words);
  if (outcome.kind == JobOutcome::Image)
    if (const auto line = failing_line(process.output, job); !line.empty())
      return {JobOutcome::Crash, fmt::format("said that it failed: {}", line), {}};
  return outcome;
}

// Whether the file was written before that time and came there later: a renderer has put an old one in its
// place. Its name was free before the render, so one that came before, too, is of a clock that was stepped
// back since.
bool is_dated_back(const fs::path& file, fs::file_time_type since) {
  struct stat status {};
  if (::lstat(file.c_str(), &status) != 0) return false;
  const auto time_of = [](const timespec& time) {
    return std::chrono::seconds(time.tv_sec) + std::chrono::nanoseconds(time.tv_nsec);
  };
  const auto ready = std::chrono::file_clock::to_sys(since).time_since_epoch();
  return time_of(status.st_mtim) < ready && time_of(status.st_ctim) >= ready;
}

// Whether there is a file to be read at all. A symbolic link could show any file of the machine as an image.
Outcome file_outcome(const adapters::Job& job, const std::string& name) {
  std::error_code ignored;
  const auto type = fs::symlink_status(job.image, ignored).type();
  if (type == fs::file_type::not_found) return {JobOutcome::NoOutput, fmt::format("wrote no {}", name), {}};
  if (type != fs::file_type::regular)
    return {JobOutcome::NoOutput,
            fmt::format("{} is no file of its own but {}", name,
                        type == fs::file_type::symlink ? "a symbolic link" : "a folder or a device"),
            {}};
  if (job.ready_since && is_dated_back(job.image, *job.ready_since))
    return {JobOutcome::Stale, fmt::format("{} is older than its render", name), {}};
  if (fs::file_size(job.image, ignored) == 0)
    return {JobOutcome::Unreadable, fmt::format("{} is empty", name), {}};
  return {};
}

// What the image says about itself must be about this render. Most renderers say nothing.
Outcome provenance_outcome(const adapters::Job& job,
                           const std::map<std::string, std::string>& attributes,
                           const std::string& name) {
  const auto differs = [&](const char* key, const std::string& expected) {
    const auto said = attributes.find(key);
    return !expected.empty() && said != attributes.end() && said->second != expected;
  };
  if (differs("orbs.scene_hash", job.scene_file_hash))
    return {JobOutcome::Stale,
            fmt::format("{} is an image of another scene, says its orbs.scene_hash", name),
            {}};
  if (differs("orbs.job", job.id))
    return {JobOutcome::Stale, fmt::format("{} is of another render, says its orbs.job", name), {}};
  return {};
}

Outcome size_outcome(const adapters::Job& job, int width_px, int height_px, const std::string& name) {
  if (width_px == job.width_px && height_px == job.height_px) return {};
  return {JobOutcome::WrongSize,
          fmt::format("{} is {} x {} pixels, expected {} x {}", name, width_px, height_px, job.width_px,
                      job.height_px),
          {}};
}

Outcome channels_outcome(const adapters::Job& job, const image::Image& image, const std::string& name) {
  for (const auto& channel : job.channels)
    if (image::channel_index(image, channel) < 0)
      return {JobOutcome::WrongChannels,
              fmt::format("{} has the channels {}, expected {}", name, fmt::join(image.channels, ", "),
                          fmt::join(job.channels, ", ")),
              {}};
  return {};
}

// Whether any channel got another name: those that the image lacks by our name and has by the renderer's.
bool rename_channels(image::Image& image, const std::map<std::string, std::string>& names) {
  bool has_renamed = false;
  for (const auto& [ours, theirs] : names) {
    const int index = image::channel_index(image, theirs);
    if (index < 0 || image::channel_index(image, ours) >= 0) continue;
    image.channels[static_cast<std::size_t>(index)] = ours;
    has_renamed = true;
  }
  return has_renamed;
}

Outcome image_outcome(const adapters::Job& job) {
  const auto name = job.image.filename().string();
  if (auto outcome = file_outcome(job, name); outcome.kind != JobOutcome::Image) return outcome;
  image::Image image;
  bool is_as_written = true;
  try {
    // Before a pixel is decoded: two megabytes can stand for two gigabytes.
    const auto header = image::read_header(job.image);
    if (auto outcome = provenance_outcome(job, header.attributes, name); outcome.kind != JobOutcome::Image)
      return outcome;
    if (auto outcome = size_outcome(job, header.width_px, header.height_px, name);
        outcome.kind != JobOutcome::Image)
      return outcome;
    image = image::read_image(job.image);
    if (job.channels != adapters::kColourChannels) {
      if (auto outcome = channels_outcome(job, image, name); outcome.kind != JobOutcome::Image)
        return outcome;
      auto colours = image::select_channels(image, job.channels);
      colours.attributes = image.attributes;
      image = std::move(colours);
      is_as_written = false;
    }
    if (rename_channels(image, job.channel_names)) is_as_written = false;
  } catch (const InputError& e) {
    return {JobOutcome::Unreadable, named_within(job.folder, e.what()), {}};
  }
  if (auto outcome = check_pixels(job, image, name); outcome.kind != JobOutcome::Image) return outcome;
  return {JobOutcome::Image, "", std::move(image), is_as_written};
}

}  // namespace

Outcome check_pixels(const adapters::Job& job, const image::Image& image, const std::string& name) {
  if (auto outcome = size_outcome(job, image.width, image.height, name); outcome.kind != JobOutcome::Image)
    return outcome;
  for (const char* channel : {"R", "G", "B"})
    if (image::channel_index(image, channel) < 0)
      return {JobOutcome::WrongChannels,
              fmt::format("{} has the channels {}, expected R, G, B", name, fmt::join(image.channels, ", ")),
              {}};
  const auto negatives =
      job.may_be_negative ? metrics::NegativePixels::Allowed : metrics::NegativePixels::Refused;
  const auto faults = metrics::count_faults(image, negatives);
  if (!faults.first.empty())
    return {
        JobOutcome::InvalidPixels,
        fmt::format("{} pixels are NaN, {} infinite, {} negative; the first is {}; all lie in [{}]",
                    faults.nan, faults.infinite, faults.negative, faults.first, fmt::join(faults.box, ",")),
        {}};
  return {};
}

Outcome classify(const adapters::ProcessResult& process,
                 const adapters::Job& job,
                 const ProcessLimits& limits) {
  auto outcome = process_outcome(process, job, limits);
  if (outcome.kind == JobOutcome::Image) outcome = image_outcome(job);
  // Channels and what a reader quotes of a file are the renderer's words, too.
  outcome.reason = clean_text(outcome.reason);
  return outcome;
}

}  // namespace orbs::run
