#pragma once

#include "results/record.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace orbs::history {

/// A run of a history.
struct RunStamp {
  std::string name;          // its label, or its folder where it has none
  std::string started;       // local time, ISO 8601
  std::string orbs_version;  // with its commit
};

/// A mean of a channel less that of the reference, with the standard error that it has by its interval.
struct MeanLight {
  double value = 0;
  double error = 0;
};

/// One target in one run.
struct Point {
  std::size_t run = 0;  // of History::runs
  results::Verdict verdict = results::Verdict::Skipped;
  results::Expectation expectation = results::Expectation::None;
  std::optional<double> psnr_db;  // psnr_srgb8; infinite for equal images
  std::optional<double> mse;
  std::array<std::optional<MeanLight>, 3> light;
  /// CPU time of its renders; none on another kind of machine than the newest run's, or below kLeastSeconds.
  std::optional<double> cpu_seconds;
  std::string version;  // of the renderer
  /// Equal for points whose images differ by their seeds alone: program, scene, samples, what judged them.
  std::string made_by;
};

/// One target by one renderer over all runs that have it; skipped ones are left out.
struct Series {
  std::string renderer;
  std::string requirement;
  std::string case_name;
  std::string target;
  bool is_one_render = false;  // false for a difference of two scenes
  std::vector<Point> points;   // in the order of the runs
};

struct History {
  std::string suite;
  std::string size;
  std::string machine;         // whose times are shown; "" if unknown
  std::vector<RunStamp> runs;  // the oldest first
  std::vector<Series> series;
  std::vector<std::string> notes;  // what was left out, and why
};

/// The history of the newest run's suite, size and kind of machine. InputError if there is no run.
History make_history(std::vector<results::RunRecord> runs);

/// Whether the verdict of the target differs between images that differ by their seeds alone.
bool is_flaky(const Series& series);

}  // namespace orbs::history
