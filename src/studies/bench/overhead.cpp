#include "studies/bench/overhead.h"

#include "base/error.h"
#include "base/files.h"
#include "image/image_io.h"
#include "results/record_json.h"
#include "run/execute.h"

#include <cerrno>
#include <chrono>
#include <cstring>

#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

namespace orbs::studies {

namespace {

using Clock = std::chrono::steady_clock;

double ms_since(Clock::time_point begin) {
  return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
}

// A plan of one render by a program that copies the image.
run::Plan copying_plan(const scene::Scene& scene, const std::filesystem::path& image) {
  run::Plan plan;
  registry::Renderer entry;
  entry.name = "copy";
  entry.support.declares = registry::parse_features("G5/M8/L4/A4");
  entry.command.words = {"{executable}", image.string(), "{output}"};
  plan.renderers.push_back({entry, "/bin/cp"});
  plan.scenes.push_back({"scene", {}, 1, std::make_shared<const scene::Scene>(scene)});
  run::PlannedJob job;
  job.id = hash_text(0);
  job.folder = "copy/scene";
  plan.jobs.push_back(job);
  return plan;
}

double harness_ms(const run::Plan& plan, const run::WorkFolders& folders, const std::atomic<bool>* stop) {
  const auto begin = Clock::now();
  const auto& job = plan.jobs.front();
  const auto execution = run::execute(plan, job, "", folders, stop);
  const bool stopped = stop != nullptr && stop->load();
  if (!execution.image && !stopped)
    throw InputError(
        fmt::format("{}: {}", plan.renderers.front().executable.string(), execution.record.end.reason));
  if (!execution.image) return 0;
  write_file(folders.unfinished / job.folder / "job.json", results::job_json(execution.record, {}));
  put_in_place(folders.unfinished / job.folder, folders.run / job.folder);
  return ms_since(begin);
}

double bare_ms(std::vector<std::string> words) {
  std::vector<char*> argv;
  for (auto& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  const auto begin = Clock::now();
  pid_t pid = 0;
  if (const int error = ::posix_spawn(&pid, argv[0], nullptr, nullptr, argv.data(), environ); error != 0)
    throw InputError(fmt::format("{}: {}", words.front(), std::strerror(error)));
  while (::waitpid(pid, nullptr, 0) < 0 && errno == EINTR) {
  }
  return ms_since(begin);
}

}  // namespace

std::optional<Overhead> measure_overhead(const scene::Scene& scene,
                                         const image::Image& image,
                                         int rounds,
                                         const std::filesystem::path& scratch,
                                         const std::atomic<bool>* stop) {
  make_folder(scratch);
  image::write_exr(image, scratch / "image.exr");
  const auto plan = copying_plan(scene, scratch / "image.exr");
  const run::WorkFolders folders{scratch / "run", scratch / "run/unfinished"};
  std::vector<double> harness;
  std::vector<double> bare;
  for (int round = 0; round < rounds; ++round) {
    harness.push_back(harness_ms(plan, folders, stop));
    if (stop != nullptr && stop->load()) return std::nullopt;
    bare.push_back(bare_ms(
        {"/bin/cp", (scratch / "image.exr").string(), (scratch / "run/copy/scene/result.exr").string()}));
  }
  return Overhead{*spread_of(harness), *spread_of(bare)};
}

}  // namespace orbs::studies
