#pragma once

#include "run/plan/plan.h"

#include <functional>
#include <string>

namespace orbs::run {

/// A program that has not run since the machine started is read from the disk first, which takes Blender more
/// than five seconds. So one that does not answer is asked once more, with more time.
struct VersionRequest {
  double first_seconds = 5;
  double second_seconds = 30;
  std::function<void(const std::string&)> say = {};  // that it is asked once more, and why there is no answer
};

/// What the version command prints: the group of version_pattern in the first line that matches it, or the
/// first line that is not empty. "unknown" with the reason when there is none. "" when the renderer has no
/// such command, and when the command was killed or took too long: what it says another time is no other
/// version. In a sandbox if the plan's settings say so.
std::string renderer_version(const ChosenRenderer& renderer,
                             const Plan& plan,
                             const VersionRequest& request = {});

/// Whether two answers name two versions. One that is not known differs from none.
bool is_other_version(const std::string& one, const std::string& other);

}  // namespace orbs::run
