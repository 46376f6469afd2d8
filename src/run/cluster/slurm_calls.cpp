#include "run/cluster/slurm_calls.h"

#include "adapters/process/process.h"
#include "adapters/process/programs.h"
#include "base/error.h"
#include "base/text.h"

#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

namespace orbs::run {

namespace {

struct Answer {
  bool has_failed = false;
  std::string text;
};

Answer call(const std::vector<std::string>& words) {
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
  return {!process.start_error.empty() || process.signal != 0 || process.exit_code != 0,
          std::string(trim(process.output))};
}

InputError failure(const std::vector<std::string>& words, const Answer& answer) {
  return InputError(fmt::format("{} failed: {}", shell_text(words), clean_text(answer.text)));
}

}  // namespace

std::string submit(const std::vector<std::string>& words) {
  const auto answer = call(words);
  if (answer.has_failed) throw failure(words, answer);
  // With several clusters, "id;cluster".
  return split(answer.text, ';').front();
}

std::vector<std::string> queue_words(const std::vector<std::string>& arrays) {
  return {"squeue", "--noheader", "--array", fmt::format("--jobs={}", fmt::join(arrays, ",")),
          "--format=%F_%K"};
}

Queued queued_in(const std::string& lines) {
  std::set<std::string> arrays;
  std::set<int> tasks;
  for (const auto& line : split(lines, '\n')) {
    const auto text = std::string(trim(line));
    if (text.empty()) continue;
    const auto parts = split(text, '_');
    const auto task = to_integer(parts.back());
    if (parts.size() != 2 || !task)
      throw InputError(
          fmt::format("squeue: expected lines such as 123_4, an array and its task; found '{}'", text));
    arrays.insert(parts.front());
    tasks.insert(static_cast<int>(*task));
  }
  return {{arrays.begin(), arrays.end()}, {tasks.begin(), tasks.end()}};
}

Queued ask_queue(const std::vector<std::string>& arrays) {
  if (arrays.empty()) return {};
  const auto words = queue_words(arrays);
  const auto answer = call(words);
  // Slurm forgets jobs some minutes after their end (MinJobAge), and then says this.
  if (answer.has_failed && answer.text.find("Invalid job id") != std::string::npos) return {};
  if (answer.has_failed)
    throw InputError(fmt::format(
        "{}; nothing was submitted, since the shards may still wait in Slurm's queue; try again when it answers",
        failure(words, answer).what()));
  return queued_in(answer.text);
}

}  // namespace orbs::run
