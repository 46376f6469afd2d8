#pragma once

#include "runner/plan.h"

#include <string>
#include <vector>

/// A run at a reduced size: every scene is seen by its own camera with fewer pixels, so that an image of a
/// renderer with a box filter is, up to noise, the full image averaged over blocks of pixels.
namespace orbs::runner {

/// Divides the cameras of the plan's scenes and the regions of its cases by settings.size_divisor. A scene
/// that cannot be divided keeps its camera and says so in size_problem; nothing may render it.
void reduce_size(Plan& plan);

/// Why the renderer's image of a target of the case, made from `scenes`, cannot be measured at the size of
/// the run; "" if it can. To be asked after reduce_size.
std::string why_not_at_size(const Plan& plan,
                            const registry::Renderer& renderer,
                            const registry::Case& one_case,
                            const std::string& target,
                            const std::vector<std::string>& scenes);

}  // namespace orbs::runner
