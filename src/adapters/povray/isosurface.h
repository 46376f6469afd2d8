#pragma once

#include "scene/shapes/shape.h"

#include <string>

namespace orbs::adapters::povray {

/// The isosurface, without closing bracket. Its max_gradient, below which POV-Ray passes over roots, is a
/// proven bound: that of interval arithmetic over cells of the box.
std::string isosurface_text(const scene::ImplicitForm& form, bool is_operand);

/// Why the surface cannot be written, "" when it can: formulas that are too long, gradients without bound.
std::string isosurface_limit(const scene::ImplicitForm& form);

}  // namespace orbs::adapters::povray
