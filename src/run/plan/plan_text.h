#pragma once

#include "run/plan/plan.h"

#include <string>

namespace orbs::run {

/// The plan for people: one line per job with its commands, or the reason why a scene is not rendered where
/// it is known before the run.
std::string plan_text(const Plan& plan);

}  // namespace orbs::run
