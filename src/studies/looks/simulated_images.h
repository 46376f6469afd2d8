#pragma once

#include "image/image.h"

#include <array>
#include <cstddef>
#include <random>
#include <vector>

namespace orbs::studies {

/// What the noise of pixels has in common with that of others. Filtered: a sample reaches over 3 x 3 px.
/// Repeated: the random numbers of a tile of 8 x 8 px are those of all tiles. Shared: every render has a part
/// that all of its pixels share, of a tenth of a pixel's own noise.
enum class InCommon { Nothing, Filtered, Repeated, Shared };

struct SampleLaw {
  const char* name;
  bool has_fireflies = false;  // 3 % of the light in one of 50,000 samples
  bool is_computed = false;    // the reference: a formula, without noise
  InCommon in_common = InCommon::Nothing;
  bool is_for_all_gates = false;  // they are judged together
};

inline constexpr std::array kSampleLaws{
    SampleLaw{"plain"},
    SampleLaw{"fireflies", true},
    SampleLaw{"fireflies of a formula", true, true, InCommon::Nothing, true},
    SampleLaw{"filtered", false, false, InCommon::Filtered, true},
    SampleLaw{"repeated", false, false, InCommon::Repeated, true},
    SampleLaw{"shared", false, false, InCommon::Shared, true}};

inline constexpr int kSimulatedSide_px = 48;

using Values = std::vector<double>;  // one per pixel and channel
using Random = std::mt19937_64;

std::size_t simulated_index(int x, int y);

/// A gradient with squares of twice the light: edges, tiles, dark and bright.
Values simulated_values();

/// A render of a scene with these values, of n samples per pixel. It states its variances as a renderer would
/// that knows its samples; with noise in common it states none, as a renderer that does not know of it.
image::Image simulated_image(const Values& values, const SampleLaw& law, int n, Random& random);

/// The reference of simulated_values.
image::Image simulated_reference(const SampleLaw& law, int n, Random& random);

}  // namespace orbs::studies
