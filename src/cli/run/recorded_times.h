#pragma once

#include "run/plan/plan.h"

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace orbs::cli {

/// Seconds that the jobs of a plan are expected to take, and the most memory that they took. What was never
/// measured has no entry.
struct RecordedTimes {
  std::map<std::string, double> seconds{};  // by job id
  std::size_t from_elsewhere = 0;           // so many of them were timed on another machine
  std::size_t rough = 0;                    // so many are known by other sizes or other scenes alone
  std::set<std::string> finished{};         // ids of jobs that the resumed runs have already
  std::map<std::string, std::size_t> peak_rss_bytes{};  // by job id; with as many threads, or more
};

/// The results.json of all runs that lie in these folders, the newest first by the time of the file, as two
/// runs may have started in one second.
std::vector<std::filesystem::path> results_files(const std::set<std::filesystem::path>& folders);

/// As far as earlier runs tell: the newest in `folders`, under any name, and the runs in
/// `resumed`, finished or not, which come first. Times of other sample counts are scaled, but not where both
/// take as many as a verdict needs, and, where a render
/// was never timed at this size, those of other sizes. For the rest, the times that come with the program
/// (data/bench): CPU seconds of another machine, shared by the threads of a job.
RecordedTimes recorded_times(const run::Plan& plan,
                             const std::set<std::filesystem::path>& folders,
                             const std::vector<std::filesystem::path>& resumed);

/// "113 renders, about 5 h"; where not all were timed, of how many that is known, and where others timed
/// them.
std::string amount_text(const run::Plan& plan, const RecordedTimes& times);

}  // namespace orbs::cli
