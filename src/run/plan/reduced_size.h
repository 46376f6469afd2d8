#pragma once

#include "run/plan/plan.h"

#include <string>
#include <vector>

/// A run at a reduced size: every scene is seen by its own camera with fewer pixels, so that an image of a
/// renderer with a box filter is, up to noise, the full image averaged over blocks of pixels.
namespace orbs::run {

/// Divides the cameras of the plan's scenes and the regions of its cases by settings.size_divisor. A scene
/// that cannot be divided keeps its camera and says so in size_problem; nothing may render it.
void reduce_size(Plan& plan);

/// The samples per pixel of the scene's case, or more where at a reduced size its few pixels would get fewer
/// camera paths than their means need. A renderer without noise has no use for more.
int enough_spp(const Plan& plan, const PlannedScene& scene, const registry::Renderer& renderer);

/// Why the renderer's image of a target of the case, made from `scenes`, cannot be measured at the size of
/// the run; "" if it can. To be asked after reduce_size.
std::string why_not_at_size(const Plan& plan,
                            const registry::Renderer& renderer,
                            const registry::Case& one_case,
                            const std::string& target,
                            const std::vector<std::string>& scenes);

}  // namespace orbs::run
