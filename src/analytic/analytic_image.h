#pragma once

#include "image/image.h"
#include "registry/analytic.h"
#include "scene/scene.h"

namespace orbs::analytic {

/// The image that the formula gives for this camera: R, G, B, of polarised light S1 to S3 too, each pixel the mean over its square to about
/// 1e-6 of its value, 1e-4 where an edge crosses it. No renderer has a part in it. InputError where the
/// formula has no closed form for its numbers.
image::Image analytic_image(const registry::AnalyticImage& formula, const scene::Camera& camera);

}  // namespace orbs::analytic
