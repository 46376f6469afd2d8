#include "studies/bench/overhead.h"

#include "base/error.h"
#include "base/files.h"
#include "image/image_io.h"
#include "results/record.h"
#include "run/execute.h"

#include <cerrno>
#include <chrono>
#include <cstring>

#include <fcntl.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/time.h>
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

struct Taken {
  double wall_ms = 0;
  double cpu_ms = 0;
  int status = 0;
};

double ms_of(const timeval& time) {
  return 1e3 * static_cast<double>(time.tv_sec) + 1e-3 * static_cast<double>(time.tv_usec);
}

Taken taken_by(std::vector<std::string> words) {
  std::vector<char*> argv;
  for (auto& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  posix_spawn_file_actions_t quiet;
  ::posix_spawn_file_actions_init(&quiet);
  ::posix_spawn_file_actions_addopen(&quiet, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  const auto begin = Clock::now();
  pid_t pid = 0;
  const int error = ::posix_spawn(&pid, argv[0], &quiet, nullptr, argv.data(), environ);
  ::posix_spawn_file_actions_destroy(&quiet);
  if (error != 0) throw InputError(fmt::format("{}: {}", words.front(), std::strerror(error)));
  Taken taken;
  rusage usage{};
  while (::wait4(pid, &taken.status, 0, &usage) < 0 && errno == EINTR) {
  }
  taken.wall_ms = ms_since(begin);
  taken.cpu_ms = ms_of(usage.ru_utime) + ms_of(usage.ru_stime);
  return taken;
}

double cpu_ms(const std::vector<std::string>& words) {
  const auto taken = taken_by(words);
  if (taken.status != 0)
    throw InputError(fmt::format("{} has failed, status {}", fmt::join(words, " "), taken.status));
  return taken.cpu_ms;
}

}  // namespace

Start measure_start(const std::filesystem::path& build,
                    const std::filesystem::path& scene,
                    int rounds,
                    const std::filesystem::path& scratch) {
  make_folder(scratch);
  const auto orbs = (build / "orbs").string();
  const auto tracer = (build / "orbs-tracer").string();
  const std::vector<std::string> pixel{tracer,      scene.string(),
                                       "-o",        (scratch / "pixel.exr").string(),
                                       "--width",   "1",
                                       "--height",  "1",
                                       "--spp",     "1",
                                       "--threads", "1"};
  std::vector<double> orbs_version;
  std::vector<double> tracer_version;
  std::vector<double> pixel_render;
  for (int round = 0; round < rounds; ++round) {
    orbs_version.push_back(cpu_ms({orbs, "--version"}));
    tracer_version.push_back(cpu_ms({tracer, "--version"}));
    pixel_render.push_back(cpu_ms(pixel));
  }
  return {*spread_of(orbs_version), *spread_of(tracer_version), *spread_of(pixel_render)};
}

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
    bare.push_back(taken_by({"/bin/cp", (scratch / "image.exr").string(),
                             (scratch / "run/copy/scene/result.exr").string()})
                       .wall_ms);
  }
  return Overhead{*spread_of(harness), *spread_of(bare)};
}

}  // namespace orbs::studies
