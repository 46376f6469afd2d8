#pragma once

#include "scene/scene.h"

#include <string>

namespace orbs::adapters::mitsuba {

/// `<emitter type="area">` of that radiance, to stand in a shape.
std::string area_emitter(scene::Rgb radiance);

/// A light as a shape that emits towards its normal; from behind black and opaque.
std::string light_text(const scene::Light& light);

}  // namespace orbs::adapters::mitsuba
