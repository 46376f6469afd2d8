#pragma once

#include "results/record.h"

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
  /// `seconds` by job id: what each render is expected to take, as far as that is known; `jobs` are done at a
  /// time.
  RunProgress(std::map<std::string, double> seconds, std::vector<std::string> ids, int jobs);
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
  void print(const std::string& line);
  void draw();
  void clear();
  std::string bar() const;
  double seconds_left() const;  // below 0: unknown

  std::map<std::string, double> seconds_;
  std::vector<std::string> waiting_;  // ids of jobs that have not ended
  int jobs_;
  int width_;  // of the terminal; 0: there is none, and no bar
  std::size_t done_ = 0;
  std::size_t count_ = 0;
  double timed_seconds_ = 0;  // of the renders of this run that have ended
  int timed_ = 0;
  std::map<std::string, Running> running_;  // by job id
  std::mutex mutex_;
  std::condition_variable_any changed_;
  std::jthread ticker_;  // draws once a second, so that the bar lives
};

}  // namespace orbs::cli
