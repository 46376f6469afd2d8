#pragma once

#include <array>

namespace orbs::image {

/// Refuses the chromaticities of red, green, blue and white (x and y of each) of an image that are not those
/// of Rec.709. They are refused and not converted, since a conversion would correlate the noise of the
/// channels, and what the renderer states of their variances would no longer hold. `name`: of the attribute.
void check_rec709(const char* name, const std::array<float, 8>& found);

}  // namespace orbs::image
