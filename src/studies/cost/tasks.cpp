#include "studies/cost/tasks.h"

#include <algorithm>
#include <optional>
#include <random>

namespace orbs::studies {

namespace {

// The ladder of the comparison of a renderer with itself: the first renderer's cheapest, so that it is there
// early. By the samples of its last rung, the time of which is what is compared.
std::optional<std::size_t> self_ladder(const CostRecord& record) {
  std::optional<std::size_t> cheapest;
  double least = 0;
  for (std::size_t i = 0; i < record.ladders.size(); ++i) {
    const auto& ladder = record.ladders[i];
    if (ladder.renderer != 0 || ladder.rungs.empty()) continue;
    const auto& target = record.targets[ladder.target];
    const double samples = static_cast<double>(ladder.rungs.back().spp) * target.width_px * target.height_px;
    if (cheapest && samples >= least) continue;
    cheapest = i;
    least = samples;
  }
  return cheapest;
}

}  // namespace

std::vector<CostTask> tasks_of_round(const CostRecord& record, int round) {
  std::vector<CostTask> tasks;
  constexpr int kSeedsOfRung = 1000;  // so that no two rungs share a seed: nested samples are not independent
  const auto self = self_ladder(record);
  for (std::size_t i = 0; i < record.ladders.size(); ++i) {
    const auto& ladder = record.ladders[i];
    if (ladder.rungs.empty()) continue;
    CostRender wanted{
        .target = ladder.target, .renderer = ladder.renderer, .purpose = kFixed, .seed = 1 + round};
    tasks.push_back({wanted, i, 0, false});
    wanted.purpose = kOfRung;
    for (std::size_t rung = 0; rung < ladder.rungs.size(); ++rung) {
      wanted.rung = ladder.rungs[rung].name;
      wanted.spp = ladder.rungs[rung].spp;
      wanted.seed = 1 + round + kSeedsOfRung * (1 + static_cast<int>(rung));
      tasks.push_back({wanted, i, rung, round == 0});
    }
    if (self != i) continue;
    wanted.purpose = kAgain;
    wanted.seed += kSeedsOfRung;
    tasks.push_back({wanted, i, ladder.rungs.size() - 1, false});
  }
  std::mt19937 random(static_cast<unsigned>(record.settings.order_seed) * 1000U +
                      static_cast<unsigned>(round));
  for (std::size_t i = tasks.size(); i > 1; --i) std::swap(tasks[i - 1], tasks[random() % i]);
  return tasks;
}

bool is_done(const CostRecord& record, const CostRender& wanted) {
  return std::any_of(record.renders.begin(), record.renders.end(), [&](const CostRender& render) {
    return render.target == wanted.target && render.renderer == wanted.renderer &&
           render.purpose == wanted.purpose && render.rung == wanted.rung && render.seed == wanted.seed;
  });
}

}  // namespace orbs::studies
