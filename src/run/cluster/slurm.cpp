#include "run/cluster/slurm.h"

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

namespace orbs::run {

namespace {

namespace fs = std::filesystem;

constexpr const char* kSlurmFile = "slurm.json";

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

// After a second array there are two merges, of which the later one may find all done.
std::string merge_script(const SlurmJob& job) {
  return fmt::format(
      "#!/bin/sh\ncd {} || exit\n[ -e merged/results.json ] && exit\n{} merge shard-*/ --output merged\n",
      shell_text({job.folder.string()}), shell_text({job.program}));
}

// Slurm replaces %a and the like in the names of the files of output: %% stands for the sign.
std::string as_pattern(const std::string& path) {
  return fmt::format("{}", fmt::join(split(path, '%'), "%%"));
}

bool is_complete(const fs::path& folder) {
  try {
    const auto run = results::read_run_folder(folder).run;
    return run.finished && !run.interrupted;
  } catch (const InputError&) {
    return false;
  }
}

// Of two options of one name sbatch takes the later one: what the user says is the last word.
std::vector<std::string> call_of_sbatch(const SlurmJob& job,
                                        const std::string& name,
                                        const std::vector<std::string>& resources,
                                        const std::string& script) {
  std::vector<std::string> words{"sbatch", "--parsable", fmt::format("--job-name={}", name),
                                 fmt::format("--chdir={}", job.folder.string())};
  words.insert(words.end(), resources.begin(), resources.end());
  const auto& settings = job.settings;
  if (!settings.partition.empty()) words.push_back(fmt::format("--partition={}", settings.partition));
  if (!settings.account.empty()) words.push_back(fmt::format("--account={}", settings.account));
  if (!settings.time.empty()) words.push_back(fmt::format("--time={}", settings.time));
  words.insert(words.end(), settings.options.begin(), settings.options.end());
  words.push_back((job.folder / script).string());
  return words;
}

}  // namespace

SlurmJob slurm_job(const registry::SlurmSettings& settings,
                   const Plan& plan,
                   const MeasuredMemory& measured_bytes,
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
  job.memory_megabytes = megabytes_of_task(plan, measured_bytes);
  job.settings = settings;
  return job;
}

void write_slurm_job(const SlurmJob& job) {
  json::Writer out;
  out.begin_object().member("format", "orbs-slurm/3").member("program", job.program);
  out.member("shards", job.shards).member("cores", job.cores);
  out.member("memory_megabytes", static_cast<unsigned long long>(job.memory_megabytes)).key("slurm");
  json::write_record(out, job.settings);
  out.key("arrays").value(job.arrays);
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
  json::check_format(in, "orbs-slurm/3");
  SlurmJob job;
  // Without the slash that a shell completes.
  job.folder = fs::absolute(folder / "").lexically_normal().parent_path();
  job.program = in.system_text("program");
  job.shards = in.integer("shards", 1, kMost);
  job.cores = in.integer("cores", 1, kMost);
  job.memory_megabytes = static_cast<std::size_t>(in.integer("memory_megabytes", 0, kMost));
  job.settings = json::read_settings<registry::SlurmSettings>(in.object("slurm"));
  job.arrays = in.texts("arrays");
  in.finish();
  return job;
}

std::size_t megabytes_of_task(const Plan& plan, const MeasuredMemory& measured_bytes) {
  // Another node has other cores, and the C library gives threads memory of their own by their number; a plan
  // may be resumed with a build that takes more.
  constexpr double kMargin = 1.5;
  // What orbs itself takes beside the render: 118 MB were seen, with images of 512 x 512 pixels.
  constexpr std::size_t kOrbs_bytes = std::size_t{256} << 20;
  std::size_t most = 0;
  for (const auto& job : plan.jobs) {
    const auto limit = plan.renderers[job.renderer].entry.limits.memory_bytes;
    const auto measured = measured_bytes.find(job.id);
    if (measured == measured_bytes.end() && !limit) return 0;
    auto bytes = limit.value_or(std::numeric_limits<std::size_t>::max());
    if (measured != measured_bytes.end())
      bytes = std::min(
          bytes, static_cast<std::size_t>(kMargin * static_cast<double>(measured->second)) + kOrbs_bytes);
    most = std::max(most, bytes);
  }
  return (most >> 20) * static_cast<std::size_t>(plan.settings.jobs);
}

fs::path shard_folder(const SlurmJob& job, int shard) { return job.folder / fmt::format("shard-{}", shard); }

std::vector<int> missing_shards(const SlurmJob& job) {
  std::vector<int> missing;
  for (int shard = 1; shard <= job.shards; ++shard)
    if (!is_complete(shard_folder(job, shard))) missing.push_back(shard);
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
  std::vector<std::string> resources{fmt::format("--array={}", array_text(shards)),
                                     fmt::format("--cpus-per-task={}", job.cores)};
  if (job.memory_megabytes > 0) resources.push_back(fmt::format("--mem={}", job.memory_megabytes));
  resources.push_back(fmt::format("--output={}/shard-%a.log", as_pattern(job.folder.string())));
  return call_of_sbatch(job, "orbs", resources, "array.sh");
}

std::vector<std::string> merge_words(const SlurmJob& job, const std::vector<std::string>& array_ids) {
  return call_of_sbatch(job, "orbs-merge",
                        {fmt::format("--dependency=afterany:{}", fmt::join(array_ids, ":")),
                         fmt::format("--output={}/merge.log", as_pattern(job.folder.string()))},
                        "merge.sh");
}

}  // namespace orbs::run
