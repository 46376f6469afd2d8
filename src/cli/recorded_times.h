#pragma once

#include "runner/plan.h"

#include <filesystem>
#include <map>
#include <string>

namespace orbs::cli {

/// Seconds that the jobs of a plan will take, by job id, as far as earlier runs tell: those in `folder` whose
/// name starts with "outputs-", and the run in `resumed` if it is not "". Times of other sample counts are
/// scaled; runs with images of another size tell nothing. What was never timed has no entry; runs that cannot
/// be read tell nothing.
std::map<std::string, double> recorded_seconds(const runner::Plan& plan,
                                               const std::filesystem::path& folder,
                                               const std::filesystem::path& resumed);

/// "45 s", "12 min", "5.2 h".
std::string duration_text(double seconds);

/// "113 renders, about 5 h"; where not all were timed, of how many that is known.
std::string amount_text(const runner::Plan& plan, const std::map<std::string, double>& seconds);

}  // namespace orbs::cli
