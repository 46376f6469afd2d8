#include "studies/cost/schedule.h"

#include "studies/cost/curve.h"
#include "studies/cost/other_load.h"
#include "studies/cost/seeds.h"

#include <algorithm>
#include <random>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace orbs::studies {

namespace {

// Without random samples, every further image would be the same; its time is measured twice.
int seeds_of(const CostRecord& record, const Sweep& sweep) {
  return sweep.is_noise_free.value_or(false) ? std::min(kSeedsOfEach, record.settings.seeds)
                                             : record.settings.seeds;
}

using Order = std::vector<std::size_t>;

// The sweeps whose samples are cheapest first; those without settings have nothing to render.
Order cheapest_first(const CostRecord& record) {
  Order order;
  for (std::size_t i = 0; i < record.sweeps.size(); ++i)
    if (!record.sweeps[i].settings.empty()) order.push_back(i);
  const auto seconds = [&](std::size_t i) {
    return record.sweeps[i].seconds_per_sample * record.sweeps[i].settings.front().spp;
  };
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return seconds(a) < seconds(b); });
  return order;
}

Order shuffled(Order order, std::mt19937& random) {
  for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[random() % i]);
  return order;
}

// One seed of one setting of a sweep, with the fixed cost before the first and the render again behind the
// one that is compared with itself.
void add_point(const CostRecord& record,
               std::size_t index,
               std::size_t setting,
               int round,
               std::vector<CostTask>& tasks) {
  const auto& sweep = record.sweeps[index];
  if (setting >= sweep.settings.size()) return;
  CostRender wanted{
      .target = sweep.target, .renderer = sweep.renderer, .purpose = Purpose::FixedCost, .seed = 1 + round};
  if (setting == 0) tasks.push_back({wanted, index, 0, false});
  wanted.purpose = Purpose::Sweep;
  wanted.setting = sweep.settings[setting].name;
  wanted.spp = sweep.settings[setting].spp;
  const auto rule = seed_rule(record, sweep);
  wanted.seed = 1 + round + seed_before(rule, sweep, setting);
  tasks.push_back({wanted, index, setting, round == 0});
  if (!rule.is_again || setting != setting_of_again(sweep)) return;
  wanted.purpose = Purpose::Again;
  wanted.seed = 1 + round + seed_before_again(rule, sweep);
  tasks.push_back({wanted, index, setting, false});
  // Which of the two comes first must not always be the same.
  if (round % 2 == 1) std::swap(tasks[tasks.size() - 2], tasks.back());
}

}  // namespace

std::vector<CostTask> cost_tasks(const CostRecord& record) {
  std::vector<CostTask> tasks;
  std::size_t most = 0;
  for (const auto& sweep : record.sweeps) most = std::max(most, sweep.settings.size());
  std::mt19937 random(static_cast<unsigned>(record.settings.order_seed));
  const auto order = cheapest_first(record);
  const auto add_round = [&](std::size_t first, std::size_t end, int round) {
    for (std::size_t setting = first; setting < end; ++setting)
      for (const auto sweep : round == 0 ? order : shuffled(order, random)) {
        if (round < seeds_of(record, record.sweeps[sweep])) add_point(record, sweep, setting, round, tasks);
      }
  };
  const int seeds_first = std::min(kSeedsOfEach, record.settings.seeds);
  for (std::size_t setting = 0; setting < most; ++setting)
    for (int round = 0; round < seeds_first; ++round) add_round(setting, setting + 1, round);
  for (int round = seeds_first; round < record.settings.seeds; ++round) add_round(0, most, round);
  return tasks;
}

Ended make_until_spent(const std::vector<CostTask>& tasks,
                       double budget_seconds,
                       const std::function<double()>& now_seconds,
                       const std::function<bool(const CostTask&)>& make) {
  for (const auto& task : tasks) {
    if (now_seconds() >= budget_seconds) return Ended::BudgetSpent;
    if (!make(task)) return Ended::Interrupted;
  }
  return Ended::Done;
}

namespace {

// Renders of a setting, those that other work disturbed included.
int made_of(const CostRecord& record, const Sweep& sweep, const SweepSetting& setting) {
  return static_cast<int>(
      std::count_if(record.renders.begin(), record.renders.end(), [&](const CostRender& render) {
        return render.target == sweep.target && render.renderer == sweep.renderer &&
               render.purpose == Purpose::Sweep && render.setting == setting.name;
      }));
}

// Of a sweep of which it is not known how many seeds it needs, any number is enough.
bool has_fewer_seeds(const CostRecord& record, const Sweep& sweep, int made) {
  return sweep.is_noise_free && made > 0 && made < seeds_of(record, sweep);
}

}  // namespace

std::string unmeasured_text(const CostRecord& record, const Sweep& sweep) {
  std::vector<std::string> missing, partly, left_out, marked, parts;
  const int wanted = seeds_of(record, sweep);
  for (const auto& setting : sweep.settings) {
    const int made = made_of(record, sweep, setting);
    const auto counted = renders_of(record, sweep, Purpose::Sweep, setting.name);
    const int kept = static_cast<int>(counted.size());
    if (!counted.empty() && is_disturbed(*counted.front())) marked.push_back(setting.name);
    if (made == 0) missing.push_back(setting.name);
    if (has_fewer_seeds(record, sweep, made))
      partly.push_back(fmt::format("{} of {} seeds of {}", wanted - made, wanted, setting.name));
    if (kept < made)
      left_out.push_back(fmt::format("{} of {} renders of {}", made - kept, made, setting.name));
  }
  missing.insert(missing.end(), partly.begin(), partly.end());
  if (!missing.empty()) parts.push_back(fmt::format("not measured: {}", fmt::join(missing, ", ")));
  if (!left_out.empty())
    parts.push_back(fmt::format("left out because of other work: {}", fmt::join(left_out, ", ")));
  if (!marked.empty()) parts.push_back(fmt::format("disturbed by other work: {}", fmt::join(marked, ", ")));
  return fmt::format("{}", fmt::join(parts, "; "));
}

std::string unmeasured_summary(const CostRecord& record) {
  int all = 0;
  int missing = 0;
  int partly = 0;
  for (const auto& sweep : record.sweeps)
    for (const auto& setting : sweep.settings) {
      const int made = made_of(record, sweep, setting);
      ++all;
      missing += made == 0 ? 1 : 0;
      partly += has_fewer_seeds(record, sweep, made) ? 1 : 0;
    }
  if (missing + partly == 0) return "";
  return fmt::format(
      "the study ended before all was measured: of {} settings of all curves, {} were not rendered and {} with "
      "fewer seeds than wanted\n",
      all, missing, partly);
}

}  // namespace orbs::studies
