#pragma once

#include "adapters/mitsuba/colours.h"
#include "image/image.h"

#include <string>

namespace orbs::adapters::mitsuba {

/// `<emitter type="area">` of that radiance, to stand in a shape.
std::string area_emitter(const Colours& colours,
                         scene::RgbColour radiance,
                         const std::optional<scene::SpectrumUse>& spectrum);

/// A light as a shape that emits, and reflects, on the side of its normal; its back is black and opaque.
std::string light_text(const Colours& colours, const scene::Light& light);

/// The image of an environment map as Mitsuba reads it. Its rows lie on the poles and at even steps between,
/// ours in the middle of such steps: 2 n + 1 rows, of which each second one is ours and the others are means
/// of their neighbours, interpolate to the same.
image::Image rows_on_poles(const image::Image& image);
/// The emitter that shows the file. Its middle lies towards +Z, ours towards -Z.
std::string environment_map(const std::string& file, const Mat4& matrix);

/// Why the light cannot be written, "" when it can.
std::string light_limit(const scene::Light& light, const std::string& display_name);

}  // namespace orbs::adapters::mitsuba
