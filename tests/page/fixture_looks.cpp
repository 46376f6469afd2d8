#include "page/fixture_looks.h"

#include "base/files.h"
#include "page/fixture_records.h"
#include "results/run_folder.h"

#include <cmath>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

namespace orbs::page_tests {

namespace {

using results::JobRecord;
using results::LookRecord;
using results::RunRecord;
using results::TargetRecord;
using results::Verdict;

constexpr int kFirst_spp = 16;
constexpr int kMostLooks = 9;

void add_gates(TargetRecord& target) {
  target.measures.push_back({"mean_ratio_g", 0.0012, "1", "mean(result) / mean(reference) - 1", false, true});
  target.checks.push_back({"mean_ratio_g", true, "G is right", -0.007, 0.007});
  target.measures.push_back({"edge_blur", 0.05, "1", "how soft the edges are", false, true});
  target.checks.push_back({"edge_blur", true, "the edges are right", -0.2, 0.2});
}

// A render that ended after these looks, and its target.
void add(RunRecord& run,
         const std::string& case_name,
         JobRecord job,
         const std::vector<LookRecord>& looks,
         const std::string& end) {
  job.identity.spp = looks.empty() ? 64 : looks.back().spp;
  job.sampling = {
      .looks = static_cast<int>(looks.size()), .most_looks = looks.empty() ? 0 : kMostLooks, .end = end};
  auto target = target_of(case_name, job, looks.empty() ? Verdict::Pass : looks.back().verdict);
  target.looks = looks;
  add_gates(target);
  run.jobs.push_back(std::move(job));
  run.targets.push_back(std::move(target));
}

std::vector<LookRecord> decided_looks() {
  return {{16, Verdict::Inconclusive, "edge_blur", 0.11, -0.02, 0.24},
          {32, Verdict::Inconclusive, "mean_ratio_g", 0.0031, -0.0024, 0.0086},
          {64, Verdict::Pass, "mean_ratio_g", 0.0012, -0.0027, 0.0051}};
}

// The interval shrinks with the root of the samples around a value that is the limit.
std::vector<LookRecord> looks_at_the_edge() {
  std::vector<LookRecord> looks;
  for (int look = 0; look < kMostLooks; ++look) {
    const int spp = kFirst_spp << look;
    const double reach = 0.16 / std::sqrt(static_cast<double>(spp));
    const double value = 0.007 + (look % 2 == 0 ? 0.3 : -0.4) * reach;
    looks.push_back({spp, Verdict::Inconclusive, "mean_ratio_g", value, value - reach, value + reach});
  }
  return looks;
}

std::vector<LookRecord> looks_of_four_gates() {
  return {{16, Verdict::Inconclusive, "psnr_srgb8", 33.5, 32.5, 34.5},
          {32, Verdict::Inconclusive, "edge_blur", 0.19, 0.05, 0.33},
          {64, Verdict::Inconclusive, "local_bias", 0.1, 0.04, 0.16},
          {128, Verdict::Inconclusive, "mean_ratio_g", 0.0071, 0.0035, 0.0107}};
}

}  // namespace

void write_run_of_looks(const std::filesystem::path& folder) {
  auto run = blank_run({"one", "two", "three"});
  run.cases.push_back(case_of("alpha", "m3_lamp", "Light of a lamp"));
  add(run, "m3_lamp", job_of("lamp", "one", 1.2), decided_looks(), "decided");
  add(run, "m3_lamp", job_of("lamp", "two", 45), looks_at_the_edge(), "edge");
  add(run, "m3_lamp", job_of("lamp", "three", 2), {}, "");
  run.cases.push_back(case_of("alpha", "l2_mirror", "Light from a mirror"));
  add(run, "l2_mirror", job_of("mirror", "one", 0.4), {{16, Verdict::Fail, "psnr_srgb8", 20.25, {}, 21.5}},
      "decided");
  add(run, "l2_mirror", job_of("mirror", "two", 4), looks_of_four_gates(), "looks");
  add(run, "l2_mirror", job_of("mirror", "three", 3), {{16, Verdict::Fail, "", {}, {}, {}}}, "decided");
  write_run(std::move(run), folder);
}

void play_live_looks(const std::filesystem::path& folder) {
  const results::RunLock lock(folder);
  auto run = blank_run({"one"});
  run.finished = false;
  run.cases.push_back(case_of("alpha", "m3_lamp", "Light of a lamp"));
  auto first = job_of("first", "one", 0.3);
  for (auto job : {first, job_of("second", "one", 10)}) {
    job.cost.started.clear();
    job.end.outcome = results::JobOutcome::Skipped;
    run.targets.push_back(target_of("m3_lamp", job, Verdict::Skipped));
    run.jobs.push_back(std::move(job));
  }
  write_run(run, folder);
  std::cout << "ready" << std::endl;
  std::filesystem::create_directories(folder / first.files.folder);
  std::vector<LookRecord> seen;
  std::string line;
  for (const auto& look : decided_looks()) {
    if (!std::getline(std::cin, line)) break;
    seen.push_back(look);
    first.identity.spp = look.spp;
    first.cost.wall_seconds *= 2;
    first.sampling = {.looks = static_cast<int>(seen.size()),
                      .most_looks = kMostLooks,
                      .end = look.verdict == Verdict::Pass ? "decided" : ""};
    auto target = target_of("m3_lamp", first, look.verdict);
    target.looks = seen;
    add_gates(target);
    write_file(folder / first.files.folder / "job.json", results::job_json(first, {target}));
  }
  while (std::getline(std::cin, line)) continue;
}

}  // namespace orbs::page_tests
