#include "run/cluster/slurm.h"

#include "adapters/process/process.h"
#include "adapters/process/programs.h"
#include "base/error.h"
#include "base/files.h"
#include "base/text.h"
#include "json/document.h"
#include "json/field_reader.h"
#include "json/field_writer.h"
#include "json/object_reader.h"
#include "json/writer.h"
#include "results/run_folder.h"
#include "run/cluster/shard.h"
#include "run/plan/plan_file.h"

#include <algorithm>
#include <limits>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

namespace orbs::run {

namespace {

namespace fs = std::filesystem;

constexpr const char* kSlurmFile = "slurm.json";

std::size_t megabytes_of_task(const Plan& plan) {
  std::size_t most = 0;
  for (const auto& renderer : plan.renderers)
    most = std::max(most, renderer.entry.limits.memory_bytes.value_or(0));
  return (most >> 20) * static_cast<std::size_t>(plan.settings.jobs);
}

std::string shard_folder(int shard) { return fmt::format("shard-{}", shard); }

// A task that is started again goes on with what the lost one has left. Verdicts are no failures of a task.
std::string array_script(const SlurmJob& job) {
  const auto program = shell_text({job.program});
  return fmt::format(
      "#!/bin/sh\n"
      "cd {0} || exit\n"
      "part=$SLURM_ARRAY_TASK_ID\n"
      "if [ -e \"shard-$part/run.json\" ]; then\n"
      "  {1} run --resume \"shard-$part\"\n"
      "else\n"
      "  rm -rf \"shard-$part\"\n"
      "  {1} run --plan {2} --shard \"$part/{3}\" --output \"shard-$part\"\n"
      "fi\n"
      "status=$?\n"
      "[ \"$status\" -eq 1 ] || exit \"$status\"\n",
      shell_text({job.folder.string()}), program, kPlanFile, job.shards);
}

std::string merge_script(const SlurmJob& job) {
  return fmt::format("#!/bin/sh\ncd {} || exit\n{} merge shard-*/ --output merged\n",
                     shell_text({job.folder.string()}), shell_text({job.program}));
}

bool is_complete(const fs::path& folder) {
  try {
    const auto run = results::read_run_folder(folder).run;
    return run.finished && !run.interrupted;
  } catch (const InputError&) {
    return false;
  }
}

std::vector<std::string> common_words(const SlurmJob& job, const std::string& name) {
  std::vector<std::string> words{"sbatch", "--parsable", fmt::format("--job-name={}", name),
                                 fmt::format("--chdir={}", job.folder.string())};
  const auto& settings = job.settings;
  if (!settings.partition.empty()) words.push_back(fmt::format("--partition={}", settings.partition));
  if (!settings.account.empty()) words.push_back(fmt::format("--account={}", settings.account));
  if (!settings.time.empty()) words.push_back(fmt::format("--time={}", settings.time));
  words.insert(words.end(), settings.options.begin(), settings.options.end());
  return words;
}

}  // namespace

SlurmJob slurm_job(const registry::SlurmSettings& settings,
                   const Plan& plan,
                   const fs::path& folder,
                   int shards) {
  const int most = shard_count(plan);
  if (shards > most)
    throw InputError(fmt::format("--shards {} is too many: the plan can be parted into {}", shards, most));
  SlurmJob job;
  job.folder = folder;
  job.program = (plan.build / "orbs").string();
  job.shards = shards > 0 ? shards : std::min(most, kMostShards);
  job.cores = plan.threads * plan.settings.jobs;
  job.memory_megabytes = megabytes_of_task(plan);
  job.settings = settings;
  return job;
}

void write_slurm_job(const SlurmJob& job) {
  json::Writer out;
  out.begin_object().member("format", "orbs-slurm/2").member("program", job.program);
  out.member("shards", job.shards).member("cores", job.cores);
  out.member("memory_megabytes", static_cast<unsigned long long>(job.memory_megabytes)).key("slurm");
  json::write_record(out, job.settings);
  write_file(job.folder / "array.sh", array_script(job));
  write_file(job.folder / "merge.sh", merge_script(job));
  write_file(job.folder / kSlurmFile, out.end_object().text());
}

SlurmJob read_slurm_job(const fs::path& folder) {
  constexpr int kMost = std::numeric_limits<int>::max();
  std::error_code ignored;
  if (!fs::exists(folder / kSlurmFile, ignored))
    throw InputError(
        fmt::format("{}: holds no {}; name a folder that 'orbs submit' made", folder.string(), kSlurmFile));
  const auto document = json::parse_file(folder / kSlurmFile);
  json::ObjectReader in(document);
  json::check_format(in, "orbs-slurm/2");
  SlurmJob job;
  job.folder = fs::absolute(folder).lexically_normal();
  job.program = in.system_text("program");
  job.shards = in.integer("shards", 1, kMost);
  job.cores = in.integer("cores", 1, kMost);
  job.memory_megabytes = static_cast<std::size_t>(in.integer("memory_megabytes", 0, kMost));
  job.settings = json::read_settings<registry::SlurmSettings>(in.object("slurm"));
  in.finish();
  return job;
}

std::vector<int> missing_shards(const SlurmJob& job) {
  std::vector<int> missing;
  for (int shard = 1; shard <= job.shards; ++shard)
    if (!is_complete(job.folder / shard_folder(shard))) missing.push_back(shard);
  return missing;
}

std::string array_text(const std::vector<int>& shards) {
  std::vector<std::string> parts;
  for (std::size_t i = 0; i < shards.size();) {
    std::size_t last = i;
    while (last + 1 < shards.size() && shards[last + 1] == shards[last] + 1) ++last;
    parts.push_back(last == i ? fmt::format("{}", shards[i]) : fmt::format("{}-{}", shards[i], shards[last]));
    i = last + 1;
  }
  return fmt::format("{}", fmt::join(parts, ","));
}

std::vector<std::string> array_words(const SlurmJob& job, const std::vector<int>& shards) {
  auto words = common_words(job, "orbs");
  words.push_back(fmt::format("--array={}", array_text(shards)));
  words.push_back(fmt::format("--cpus-per-task={}", job.cores));
  if (job.memory_megabytes > 0) words.push_back(fmt::format("--mem={}", job.memory_megabytes));
  words.push_back(fmt::format("--output={}", (job.folder / "shard-%a.log").string()));
  words.push_back((job.folder / "array.sh").string());
  return words;
}

std::vector<std::string> merge_words(const SlurmJob& job, const std::string& array_id) {
  auto words = common_words(job, "orbs-merge");
  words.push_back(fmt::format("--dependency=afterany:{}", array_id));
  words.push_back(fmt::format("--output={}", (job.folder / "merge.log").string()));
  words.push_back((job.folder / "merge.sh").string());
  return words;
}

std::string submit(const std::vector<std::string>& words) {
  constexpr double kLimit_seconds = 60;
  const auto program = adapters::find_program(words.front());
  if (!program)
    throw InputError(fmt::format(
        "there is no program '{}' on PATH, so there is no Slurm here; on machines without it, render "
        "each part with orbs run --shard and put them together with orbs merge",
        words.front()));
  adapters::ProcessRequest request;
  request.argv = words;
  request.argv[0] = program->string();
  // Slurm hands the environment of sbatch on to the tasks.
  for (char** variable = environ; *variable != nullptr; ++variable)
    request.environment.emplace_back(*variable);
  request.limits.wall_seconds = kLimit_seconds;
  const auto process = adapters::run_process(request);
  if (!process.start_error.empty() || process.signal != 0 || process.exit_code != 0)
    throw InputError(fmt::format("{} failed: {}", shell_text(words), clean_text(trim(process.output))));
  // With several clusters, "id;cluster".
  return split(std::string(trim(process.output)), ';').front();
}

}  // namespace orbs::run
