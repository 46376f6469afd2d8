#pragma once

namespace orbs::image {

/// `value` with `bits` significant bits (1 to 23), to nearest: what fits stays exact, and compresses. Zero,
/// NaN and infinities stay what they are.
float rounded_to_bits(float value, unsigned bits);

}  // namespace orbs::image
