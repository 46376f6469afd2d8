#pragma once

#include "image/image.h"
#include "metrics/mask.h"
#include "results/target_record.h"
#include "scene/scene.h"

#include <vector>

namespace orbs::run {

/// The windows and tiles of a judged image whose mean a check found wrong for certain, the largest first,
/// each with what is seen there and how far it is off. `scene` is what the image shows, with the camera of
/// its size; nullptr where that is not one scene.
std::vector<results::WrongRegion> wrong_regions(const results::TargetRecord& record,
                                                const image::Image& result,
                                                const image::Image& reference,
                                                const metrics::Mask& mask,
                                                const scene::Scene* scene);

}  // namespace orbs::run
