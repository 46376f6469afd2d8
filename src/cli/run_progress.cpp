#include "cli/run_progress.h"

#include "base/terminal.h"
#include "base/text.h"
#include "base/text_table.h"
#include "cli/recorded_times.h"
#include "report/table.h"

#include <algorithm>
#include <optional>

#include <fmt/format.h>
#include <unistd.h>

namespace orbs::cli {

namespace {

// "[ 3/28] cycles     101                pass            39.87 dB    12.3 s"
std::string finished_line(std::size_t done,
                          std::size_t count,
                          const results::JobRecord& job,
                          const std::vector<results::TargetRecord>& targets) {
  // What was rendered and not judged for any case has no worse verdict than a pass.
  auto verdict = results::verdict_without_image(job.end.outcome).value_or(results::Verdict::Pass);
  auto expectation = results::Expectation::None;
  std::string reason = job.end.reason;
  std::optional<double> psnr;
  for (const auto& target : targets) {
    if (&target == &targets.front() ||
        results::is_worse(target.verdict, target.expectation, verdict, expectation)) {
      verdict = target.verdict;
      expectation = target.expectation;
      reason = reason_text(target);
    }
    for (const auto& measure : target.measures)
      if (measure.name == "psnr_srgb8") psnr = std::min(psnr.value_or(measure.value), measure.value);
  }
  const auto state = state_name(verdict, expectation);
  const bool good = results::passes(verdict) && expectation == results::Expectation::None;
  auto line = fmt::format("[{:>{}}/{}] {:<10} {:<18} {:<14} {:>6} dB {:>7.1f} s", done,
                          fmt::formatted_size("{}", count), count, job.identity.renderer, job.identity.scene,
                          good && targets.empty() ? "rendered" : state, report::decibels(psnr),
                          job.cost.wall_seconds);
  if (!good) line += fmt::format("  {}", reason);
  return clean_line(line);
}

bool is_terminal() {
  const char* terminal = std::getenv("TERM");
  return ::isatty(STDERR_FILENO) == 1 && terminal != nullptr && std::string_view(terminal) != "dumb";
}

}  // namespace

RunProgress::RunProgress(std::map<std::string, double> seconds, std::vector<std::string> ids, int jobs)
    : seconds_(std::move(seconds)),
      waiting_(std::move(ids)),
      jobs_(jobs),
      width_(is_terminal() ? terminal_width(STDERR_FILENO) : 0),
      count_(waiting_.size()) {
  if (width_ == 0) return;
  ticker_ = std::jthread([this](const std::stop_token& stop) {
    std::unique_lock lock(mutex_);
    while (!stop.stop_requested()) {
      changed_.wait_for(lock, stop, std::chrono::seconds(1), [] { return false; });
      if (!stop.stop_requested()) draw();
    }
  });
}

RunProgress::~RunProgress() {
  if (!ticker_.joinable()) return;
  ticker_.request_stop();
  ticker_.join();
  clear();
}

void RunProgress::started(const results::JobIdentity& job) {
  const std::lock_guard lock(mutex_);
  running_[job.id] = {fmt::format("{} {}", job.renderer, job.scene), Clock::now()};
  draw();
}

void RunProgress::finished(std::size_t done,
                           std::size_t count,
                           const results::JobRecord& job,
                           const std::vector<results::TargetRecord>& targets) {
  const std::lock_guard lock(mutex_);
  done_ = done;
  count_ = count;
  if (running_.erase(job.identity.id) > 0) {
    timed_seconds_ += job.cost.wall_seconds;
    ++timed_;
  }
  std::erase(waiting_, job.identity.id);
  print(finished_line(done, count, job, targets));
}

void RunProgress::say(const std::string& line) {
  const std::lock_guard lock(mutex_);
  print(clean_line(line));
}

void RunProgress::print(const std::string& line) {
  clear();
  const auto parts = wrapped(line, static_cast<std::size_t>(width_));
  for (std::size_t i = 0; i < parts.size(); ++i)
    print_clean(stderr, "{}{}\n", i == 0 ? "" : "    ", parts[i]);
  draw();
}

void RunProgress::clear() {
  if (width_ > 0) print_raw(stderr, "\r\x1b[K");
}

void RunProgress::draw() {
  if (width_ > 0) print_raw(stderr, "\r\x1b[K" + clean_line(bar()));
}

double RunProgress::seconds_left() const {
  double sum = 0;
  for (const auto& id : waiting_) {
    const auto known = seconds_.find(id);
    if (known == seconds_.end() && timed_ == 0) return -1;
    double left = known == seconds_.end() ? timed_seconds_ / timed_ : known->second;
    if (const auto running = running_.find(id); running != running_.end())
      left -= std::chrono::duration<double>(Clock::now() - running->second.since).count();
    sum += std::max(left, 0.0);
  }
  return sum / jobs_;
}

// "[########............] 12/113, about 3 min left: cycles 101 (12 s)", cut where the terminal ends.
std::string RunProgress::bar() const {
  constexpr std::size_t kCells = 20;
  const auto full = count_ == 0 ? 0 : kCells * done_ / count_;
  auto text =
      fmt::format("[{}{}] {}/{}", std::string(full, '#'), std::string(kCells - full, '.'), done_, count_);
  if (const double left = seconds_left(); left >= 0 && !waiting_.empty())
    text += fmt::format(", about {} left", duration_text(left));
  const char* before = ": ";
  for (const auto& [id, running] : running_) {
    text += fmt::format("{}{} ({:.0f} s)", before, running.name,
                        std::chrono::duration<double>(Clock::now() - running.since).count());
    before = ", ";
  }
  if (const auto most = static_cast<std::size_t>(width_ - 1); display_width(text) > most) text.resize(most);
  return text;
}

}  // namespace orbs::cli
