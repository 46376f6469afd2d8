#pragma once

#include "judge/judge.h"
#include "results/record.h"

#include <atomic>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace orbs::run {

/// Called after each render that was not skipped, one at a time: how many are done, of how many, the render,
/// and the images judged from it.
using Progress = std::function<void(
    std::size_t, std::size_t, const results::JobRecord&, const std::vector<results::TargetRecord>&)>;

/// Called when a render starts, one at a time.
using Started = std::function<void(const results::JobIdentity&)>;

struct RenderContext {
  std::string orbs_version;
  std::string day{};  // of the run's start, "2026-11-25", by which known failures expire; run() sets it
  const std::atomic<bool>* stop = nullptr;  // set when the user interrupts
  Started started = {};
  Progress progress;                                 // not called for jobs that an earlier run has finished
  std::function<void(const std::string&)> say = {};  // why something is rendered again
};

/// A job, and the targets that are judged from its render alone.
struct JudgedJob {
  results::JobRecord job;
  std::vector<results::TargetRecord> targets;
  std::vector<judge::Look> looks;  // by target; none for fixed samples
};

}  // namespace orbs::run
