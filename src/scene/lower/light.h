#pragma once

#include "scene/scene.h"

#include <optional>

namespace orbs::scene {

/// Whether the matrix moves and does nothing else.
bool is_translation(const Mat4& matrix);

/// The factor by which the matrix scales equally in all directions; nothing when it shears or scales
/// unevenly.
std::optional<double> uniform_scale(const Mat4& matrix);

/// A light with a translation alone that looks the same; nothing when there is none.
std::optional<Light> without_matrix(const Light& light);

}  // namespace orbs::scene
