#pragma once

#include "image/image.h"
#include "results/record.h"

#include <string>

namespace orbs::studies {

/// The image of a target that a renderer made in a run. InputError where the run has none that could be
/// judged.
image::Image control_image(const results::RunRecord& run,
                           const std::string& renderer,
                           const std::string& case_name,
                           const std::string& target);

}  // namespace orbs::studies
