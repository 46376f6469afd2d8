#pragma once

#include "adapters/mitsuba/colours.h"

#include <string>

namespace orbs::adapters::mitsuba {

/// `<emitter type="area">` of that radiance, to stand in a shape.
std::string area_emitter(const Colours& colours,
                         scene::RgbColour radiance,
                         const std::optional<scene::SpectrumUse>& spectrum);

/// A light as a shape that emits, and reflects, on the side of its normal; its back is black and opaque.
std::string light_text(const Colours& colours, const scene::Light& light);

/// Why the light cannot be written, "" when it can.
std::string light_limit(const scene::Light& light, const std::string& display_name);

}  // namespace orbs::adapters::mitsuba
