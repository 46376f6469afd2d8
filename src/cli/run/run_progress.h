#pragma once

#include "cli/run/recorded_times.h"
#include "cli/run/time_left.h"
#include "registry/run_settings.h"
#include "results/record.h"
#include "run/plan/plan.h"

#include <chrono>
#include <condition_variable>
#include <map>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace orbs::cli {

/// What `orbs run` says while it renders, on standard error: a line for each render that ends. On a terminal,
/// below these a bar with what is running and an estimate of the time left. All threads may call.
class RunProgress {
 public:
  RunProgress(const run::Plan& plan, const RecordedTimes& times);
  ~RunProgress();
  RunProgress(const RunProgress&) = delete;
  RunProgress& operator=(const RunProgress&) = delete;

  void started(const results::JobIdentity& job);
  void finished(std::size_t done,
                std::size_t count,
                const results::JobRecord& job,
                const std::vector<results::TargetRecord>& targets);
  void say(const std::string& line);

 private:
  using Clock = std::chrono::steady_clock;
  struct Running {
    std::string name;
    Clock::time_point since;
  };

  // All of these hold the lock.
  void print(const std::string& lines);  // with their ends
  void draw();
  void clear();
  std::string bar() const;
  void wait_for(const std::string& id, const std::string& renderer);

  TimeLeft left_;
  std::map<std::string, double> expected_;  // seconds by job id, of all jobs
  registry::RunSettings settings_;
  int width_;  // of the terminal; 0: there is none, and no bar
  std::size_t done_ = 0;
  std::size_t count_ = 0;
  std::map<std::string, Running> running_;  // by job id
  std::mutex mutex_;
  std::condition_variable_any changed_;
  std::jthread ticker_;  // draws once a second, so that the bar lives
};

}  // namespace orbs::cli
