#include "tracer_cli/progress_line.h"

#include "base/terminal.h"

#include <cstdio>
#include <string>

#include <fmt/format.h>
#include <unistd.h>

namespace orbs::tracer_cli {

ProgressLine::ProgressLine(bool as_json) : as_json_(as_json), on_terminal_(::isatty(STDERR_FILENO) == 1) {}

void ProgressLine::show(const tracer::Progress& progress) {
  constexpr double kInterval = 0.1;  // seconds
  if (progress.seconds < last_seconds_ + kInterval) return;
  last_seconds_ = progress.seconds;
  if (as_json_) {
    print_clean("{{\"progress\": {:.4f}, \"spp\": {}, \"seconds\": {:.2f}}}\n", progress.done,
                progress.samples_per_pixel, progress.seconds);
    std::fflush(stdout);
  } else if (on_terminal_) {
    constexpr int kWidth = 40;
    const auto full = static_cast<std::size_t>(progress.done * kWidth);
    const double left = progress.seconds / progress.done - progress.seconds;
    print_raw(stderr,
              fmt::format("\r[{}{}] {:3.0f} %  {:.0f} s, {:.0f} s left ", std::string(full, '#'),
                          std::string(kWidth - full, '.'), 100 * progress.done, progress.seconds, left));
  }
}

void ProgressLine::finish() const {
  if (on_terminal_ && !as_json_ && last_seconds_ > 0) print_raw(stderr, fmt::format("\r{:79}\r", ""));
}

}  // namespace orbs::tracer_cli
