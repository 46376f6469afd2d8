#include "studies/cost/goals.h"

#include "base/error.h"
#include "base/text_table.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace orbs::studies {

namespace {

std::size_t renderer_named(const CostRecord& record, const std::string& name) {
  for (std::size_t i = 0; i < record.renderers.size(); ++i)
    if (record.renderers[i].name == name) return i;
  throw InputError(fmt::format("the study has no renderer '{}', so it says nothing of the goals", name));
}

// The curves of the two on one scene.
struct Pair {
  const CostCurve* ours = nullptr;
  const CostCurve* other = nullptr;
};

std::optional<LogRatio> time_ratio(const Pair& pair, std::size_t error) {
  const auto& ours = pair.ours->times_to_error.at(error);
  const auto& other = pair.other->times_to_error.at(error);
  if (!ours.cpu_seconds || !other.cpu_seconds) return std::nullopt;
  return log_ratio_of(other, ours);
}

// The uncertainty of a time above the start is that of the whole time, by the share that it is of it.
std::optional<LogRatio> log_above_start(const CostCurve& curve, std::size_t error) {
  const auto& time = curve.times_to_error.at(error);
  if (!time.cpu_seconds || !curve.fixed_cpu_seconds) return std::nullopt;
  const double above = time.cpu_seconds->value - fixed_seconds(curve);
  if (!(above > 0)) return std::nullopt;
  const double deviation = time.log_error * time.cpu_seconds->value / above;
  return LogRatio{std::log(above), deviation * deviation, time.degrees};
}

std::optional<LogRatio> without_start(const Pair& pair) {
  const auto& targets = error_targets();
  std::optional<LogRatio> found;
  double level = 0;
  for (std::size_t error = 0; error < targets.size(); ++error) {
    if (targets[error].metric != kPsnr || targets[error].level < level) continue;
    const auto ours = log_above_start(*pair.ours, error);
    auto other = log_above_start(*pair.other, error);
    if (!ours || !other) continue;
    other->value = -other->value;
    found = sum_of({*ours, *other});
    level = targets[error].level;
  }
  return found;
}

std::optional<LogRatio> to_35_db(const Pair& pair) {
  const auto& targets = error_targets();
  const auto error = std::find(targets.begin(), targets.end(), ErrorTarget{kPsnr, 35}) - targets.begin();
  return time_ratio(pair, static_cast<std::size_t>(error));
}

// Over the sample counts that both have, and whose error the reference can still judge.
std::optional<LogRatio> at_equal_samples(const Pair& pair) {
  std::vector<LogRatio> logs;
  for (const auto& ours : pair.ours->points)
    for (const auto& other : pair.other->points) {
      if (ours.setting.spp != other.setting.spp || ours.is_below_reference_noise ||
          other.is_below_reference_noise || !ours.errors[kRelmse] || !other.errors[kRelmse])
        continue;
      const double first = ours.errors[kRelmse]->value;
      const double second = other.errors[kRelmse]->value;
      if (!(first > 0) || !(second > 0)) continue;
      logs.push_back(
          {std::log(first / second),
           pair.ours->relative_variance / ours.renders + pair.other->relative_variance / other.renders,
           std::max(1.0, pair.ours->degrees + pair.other->degrees)});
    }
  if (logs.empty()) return std::nullopt;
  return mean_within(logs);
}

template <class Ratio>
void fill(CostGoal& goal, const CostRecord& record, const std::vector<Pair>& pairs, const Ratio& ratio_of) {
  std::vector<LogRatio> logs;
  for (const auto& pair : pairs) {
    const auto log = ratio_of(pair);
    if (!log) continue;
    logs.push_back(*log);
    if (const double ratio = std::exp(log->value); ratio > goal.worst) {
      goal.worst = ratio;
      goal.worst_scene = record.targets[pair.ours->target].name;
    }
  }
  goal.scenes = static_cast<int>(logs.size());
  if (!logs.empty()) goal.mean = ratio_interval(mean_over(logs));
}

}  // namespace

std::string reached_text(const CostGoal& goal) {
  if (!goal.mean) return "not measured";
  if (goal.most_scene && goal.worst > *goal.most_scene) return "no";
  if (goal.mean->high <= goal.most_mean) return "yes";
  return goal.mean->low > goal.most_mean ? "no" : "not shown";
}

std::vector<CostGoal> cost_goals(const CostRecord& record,
                                 const std::string& ours,
                                 const std::string& other) {
  const auto first = renderer_named(record, ours);
  const auto second = renderer_named(record, other);
  const auto numbers = cost_numbers(record);
  std::vector<Pair> pairs;
  for (const auto& one : numbers.curves)
    for (const auto& another : numbers.curves)
      if (one.target == another.target && one.renderer == first && another.renderer == second)
        pairs.push_back({&one, &another});
  std::vector<CostGoal> goals{{"time to equal error, start left out", 1.0 / 3, 0.8},
                              {"time to 35 dB, with start", 0.25},
                              {"relMSE at equal samples", 0.9}};
  fill(goals[0], record, pairs, without_start);
  fill(goals[1], record, pairs, to_35_db);
  fill(goals[2], record, pairs, at_equal_samples);
  return goals;
}

std::string goals_markdown(const CostRecord& record, const std::string& ours, const std::string& other) {
  std::vector<TableRow> rows{
      {fmt::format("{} over {}", ours, other), "goal", "geometric mean", "scenes", "worst scene", "reached"}};
  for (const auto& goal : cost_goals(record, ours, other)) {
    auto limit = fmt::format("at most {:.2g}", goal.most_mean);
    if (goal.most_scene) limit += fmt::format(", no scene above {:g}", *goal.most_scene);
    rows.push_back(
        {goal.name, limit,
         goal.mean
             ? fmt::format("{:.2f} ({:.2f} to {:.2f})", goal.mean->value, goal.mean->low, goal.mean->high)
             : "-",
         fmt::format("{} of {}", goal.scenes, record.targets.size()),
         goal.mean ? fmt::format("{}: {:.2f}", goal.worst_scene, goal.worst) : "-", reached_text(goal)});
  }
  const auto numbers = cost_numbers(record);
  auto text = fmt::format("Study of {}, {} {}.\n", record.started.substr(0, 10), ours,
                          record.renderers[renderer_named(record, ours)].version);
  text += numbers.self_comparison
              ? fmt::format("Its comparison of a renderer with itself spans {} {}.\n",
                            numbers.self_comparison->scenes.size(),
                            numbers.self_comparison->scenes.size() == 1 ? "scene" : "scenes")
              : "It compares no renderer with itself.\n";
  const auto& load = numbers.other_load;
  text += load.unknown == load.renders
              ? "It did not measure what other work took of the machine.\n"
              : fmt::format("Left out because of other work on the machine: {} of {} renders.{}\n",
                            load.left_out, load.renders,
                            load.marked == 0 ? "" : fmt::format(" Disturbed by it: {}.", load.marked));
  return fmt::format("{}\n{}", text, markdown_table(rows));
}

}  // namespace orbs::studies
