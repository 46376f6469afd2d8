#pragma once

#include "run/plan/plan.h"

#include <cstddef>
#include <vector>

namespace orbs::run {

/// By job, the first job of its group: those that share a target, as a difference of two scenes.
std::vector<std::size_t> group_of_jobs(const Plan& plan);

}  // namespace orbs::run
