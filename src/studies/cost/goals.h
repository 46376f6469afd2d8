#pragma once

#include "studies/cost/numbers.h"

#include <optional>
#include <string>
#include <vector>

/// What the built-in tracer is to reach against another renderer, and what a study shows of it.
namespace orbs::studies {

struct CostGoal {
  std::string name;
  double most_mean = 0;                // of the geometric mean over the scenes
  std::optional<double> most_scene{};  // of every scene
  std::optional<Interval> mean{};      // nothing where no scene can be compared
  int scenes = 0;                      // of which the mean is
  std::string worst_scene{};
  double worst = 0;  // its ratio
};

/// Whether the mean and every scene are within what is allowed: "yes" only if the whole interval of the mean
/// is, "no" if none of it is or a scene is beyond, "not shown" otherwise.
std::string reached_text(const CostGoal& goal);

/// Ratios of `ours` to `other`, the names of renderers of the study: time to equal error without the start,
/// time with the start to 35 dB, relMSE at equal samples. The equal error is the highest PSNR to which both
/// times are exact. InputError when the study lacks one of the renderers.
std::vector<CostGoal> cost_goals(const CostRecord& record, const std::string& ours, const std::string& other);

/// As a Markdown table, with a sentence on the study that it is of.
std::string goals_markdown(const CostRecord& record, const std::string& ours, const std::string& other);

}  // namespace orbs::studies
