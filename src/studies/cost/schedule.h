#pragma once

#include "studies/cost/record.h"

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

/// Which render of a study comes when, so that a budget that ends early has been shared by all curves.
namespace orbs::studies {

/// Renders of each point without which there is no scatter and so no interval.
inline constexpr int kSeedsOfEach = 2;

/// A render to be made.
struct CostTask {
  CostRender render;  // without what is measured
  std::size_t sweep = 0;
  std::size_t setting = 0;
  bool is_first = false;  // its image is kept
};

/// All renders of the study, in the order in which they are made. Round robin: the fixed cost and the first
/// setting of every curve, the cheapest curve first, then the second setting of every curve, and so on; of
/// each point two seeds, then the others of all. The second seed goes through the curves in an order that the
/// study's seed shuffles, and so do those behind it, so that drift of the machine hits all alike. The first
/// renderer renders the last of its first three settings once more next to it, on every scene, for its
/// comparison with itself.
std::vector<CostTask> cost_tasks(const CostRecord& record);

/// How the tasks ended.
enum class Ended { Done, BudgetSpent, Interrupted };

/// Makes the tasks one after the other until `now_seconds` reaches the budget: none begins after that. A task
/// that gives false was interrupted.
Ended make_until_spent(const std::vector<CostTask>& tasks,
                       double budget_seconds,
                       const std::function<double()>& now_seconds,
                       const std::function<bool(const CostTask&)>& make);

/// What is missing of a sweep: "not measured: 128 spp, 1 of 4 seeds of 64 spp; left out because of other
/// work: 1 of 4 renders of 32 spp". "" when nothing is.
std::string unmeasured_text(const CostRecord& record, const Sweep& sweep);

/// One line on all sweeps: how many of their settings were not measured, and how many with fewer seeds. ""
/// when nothing is missing.
std::string unmeasured_summary(const CostRecord& record);

}  // namespace orbs::studies
