#pragma once

#include "base/matrix.h"
#include "scene/lights/ies.h"

#include <string>

/// IES profiles for HydraCore3. It reads no angle but the first and the last, puts the n values of a range
/// into the middles of n equal parts, takes half a circle for a quadrant, and only files with line feeds
/// alone. So a profile becomes a grid of its own.
namespace orbs::adapters::hydra {

struct IesGrid {
  std::string text;  // of the file
  double peak = 0;   // the largest value as a share of that of the profile; HydraCore3 divides by it
};

IesGrid ies_grid(const scene::IesProfile& profile);

/// Why the profile cannot stand on a light with this matrix, "" when it can; what follows the light's name.
std::string ies_limit(const scene::IesUse& use, const Mat4& light);

/// The matrix of the profile as HydraCore3 has it: it acts on the direction in the world, before the light's
/// own is undone, and azimuths run the other way than ours. ies_limit must be "".
Mat4 ies_matrix(const scene::IesUse& use, const Mat4& light);

}  // namespace orbs::adapters::hydra
