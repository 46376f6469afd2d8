#include "studies/cost/curve.h"

#include <cmath>

#include <fmt/format.h>

namespace orbs::studies {

const std::vector<CostGoal>& cost_goals() {
  static const std::vector<CostGoal> goals{{kPsnr, 30},     {kPsnr, 35},     {kPsnr, 40},    {kPsnr, 45},
                                           {kRelmse, 1e-2}, {kRelmse, 1e-3}, {kRelmse, 1e-4}};
  return goals;
}

std::string goal_text(const CostGoal& goal) {
  return goal.metric == kPsnr ? fmt::format("{:g} dB", goal.level)
                              : fmt::format("relMSE 1e{:.0f}", std::log10(goal.level));
}

double mse_of_psnr(double decibels) { return 255 * 255 * std::pow(10, -decibels / 10); }

}  // namespace orbs::studies
