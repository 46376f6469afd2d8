#include "cli/run/run_progress.h"

#include "base/duration.h"
#include "base/terminal.h"
#include "base/text.h"
#include "base/text_table.h"
#include "report/short_reason.h"
#include "report/table.h"

#include <algorithm>
#include <optional>

#include <fmt/format.h>
#include <unistd.h>

namespace orbs::cli {

namespace {

// The reason behind the line, or below it where there is no room for it.
std::string with_reason(const std::string& line, const std::string& reason, int width) {
  constexpr int kIndent = 6;
  const auto both = fmt::format("{}  {}\n", line, reason);
  if (width == 0 || display_width(both) <= static_cast<std::size_t>(width)) return both;
  auto text = line + '\n';
  for (const auto& part : wrapped(reason, static_cast<std::size_t>(std::max(width - kIndent, 1))))
    text += fmt::format("{}{}\n", std::string(kIndent, ' '), part);
  return text;
}

// "[ 3/28] cycles     101                pass            39.87 dB    12.3 s"; "" where nothing is to be said.
std::string finished_line(std::size_t done,
                          std::size_t count,
                          const results::JobRecord& job,
                          const std::vector<results::TargetRecord>& targets,
                          const registry::RunSettings& settings,
                          int width) {
  // What was rendered and not judged for any case has no worse verdict than a pass.
  auto verdict = results::verdict_without_image(job.end.outcome).value_or(results::Verdict::Pass);
  auto expectation = results::Expectation::None;
  std::string reason = job.end.reason;
  std::optional<double> psnr;
  std::optional<double> without_noise;  // of the target with that PSNR
  for (const auto& target : targets) {
    if (&target == &targets.front() ||
        results::is_worse(target.verdict, target.expectation, verdict, expectation)) {
      verdict = target.verdict;
      expectation = target.expectation;
      reason = reason_text(target);
    }
    const auto of_target = psnr_db(target);
    if (!of_target || (psnr && *psnr <= *of_target)) continue;
    psnr = of_target;
    without_noise = deciding_psnr_without_noise_db(target);
  }
  const auto state = state_name(verdict, expectation);
  const bool good = results::passes(verdict) && expectation == results::Expectation::None;
  const bool fails = results::counts_as_failure(verdict, expectation);
  if (settings.quiet && !fails) return "";
  const auto line =
      fmt::format("[{:>{}}/{}] {:<10} {:<18} {:<14} {:>6} dB {:>7.1f} s{}", done,
                  fmt::formatted_size("{}", count), count, job.identity.renderer, job.identity.scene,
                  good && targets.empty() ? "rendered" : state, report::decibels(psnr), job.cost.wall_seconds,
                  without_noise ? "  " + report::without_noise_text(*without_noise) : "");
  if (good) return clean_line(line) + '\n';
  return with_reason(
      clean_line(line),
      clean_line(settings.verbose ? reason : report::line_reason(verdict, expectation, reason, width)),
      width);
}

bool is_terminal() {
  const char* terminal = std::getenv("TERM");
  return ::isatty(STDERR_FILENO) == 1 && terminal != nullptr && std::string_view(terminal) != "dumb";
}

}  // namespace

RunProgress::RunProgress(const run::Plan& plan, const RecordedTimes& times)
    : expected_(times.seconds),
      settings_(plan.settings),
      width_(is_terminal() ? terminal_width(STDERR_FILENO) : 0),
      count_(plan.jobs.size()) {
  for (const auto& job : plan.jobs)
    if (!times.finished.contains(job.id)) wait_for(job.id, plan.renderers[job.renderer].entry.name);
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

void RunProgress::wait_for(const std::string& id, const std::string& renderer) {
  const auto known = expected_.find(id);
  left_.add(id, renderer, known == expected_.end() ? std::nullopt : std::optional(known->second));
}

void RunProgress::started(const results::JobIdentity& job) {
  const std::lock_guard lock(mutex_);
  running_[job.id] = {fmt::format("{} {}", job.renderer, job.scene), Clock::now()};
  wait_for(job.id, job.renderer);  // also for one of an earlier run that is outdated
  left_.started(job.id, Clock::now());
  draw();
}

void RunProgress::finished(std::size_t done,
                           std::size_t count,
                           const results::JobRecord& job,
                           const std::vector<results::TargetRecord>& targets) {
  const std::lock_guard lock(mutex_);
  done_ = done;
  count_ = count;
  running_.erase(job.identity.id);
  left_.ended(job.identity.id, job.cost.wall_seconds);
  const auto lines = finished_line(done, count, job, targets, settings_, width_);
  if (lines.empty())
    draw();
  else
    print(lines);
}

void RunProgress::say(const std::string& line) {
  const std::lock_guard lock(mutex_);
  print(wrapped_lines(clean_line(line), width_));
}

void RunProgress::print(const std::string& lines) {
  clear();
  print_clean(stderr, "{}", lines);
  draw();
}

void RunProgress::clear() {
  if (width_ > 0) print_raw(stderr, "\r\x1b[K");
}

void RunProgress::draw() {
  if (width_ > 0) print_raw(stderr, "\r\x1b[K" + clean_line(bar()));
}

// "[########............] 12/113, about 3 min left: cycles 101 (12 s)", cut where the terminal ends.
std::string RunProgress::bar() const {
  constexpr std::size_t kCells = 20;
  const auto full = count_ == 0 ? 0 : kCells * done_ / count_;
  auto text =
      fmt::format("[{}{}] {}/{}", std::string(full, '#'), std::string(kCells - full, '.'), done_, count_);
  if (const auto left = left_.seconds(Clock::now(), settings_.jobs); left && !left_.is_over())
    text += fmt::format(", about {} left", duration_text(*left));
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
