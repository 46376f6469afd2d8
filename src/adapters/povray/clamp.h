#pragma once

#include "base/vec.h"
#include "scene/scene.h"

#include <array>
#include <vector>

namespace orbs::adapters::povray {

/// A corner of a triangle with the texture coordinates that the image is looked up at (texture matrix
/// applied).
struct Corner {
  Vec3d position;
  Vec3d normal;
  Vec2d uv;
};

/// False for slivers, which POV-Ray refuses.
bool has_area(const std::array<Corner, 3>& triangle);

/// Where coordinates of one axis stop. POV-Ray repeats an image or shows nothing beyond its edge, so a
/// clamped axis is cut at `low` and `high` and every coordinate beyond is moved there. Repeated axes have no
/// bounds.
struct ClampAxis {
  bool active = false;
  double low = 0;
  double high = 1;
};

/// How the clamped axes of a texture are cut. With both axes clamped the image is looked up "once" and the
/// bounds are just inside its edge. With one, POV-Ray's filter wraps around at both, and the bounds are the
/// centres of the outer texels; they depend on the size of the image, which must be a PNG, whose header is
/// read. InputError when the size cannot be read.
std::array<ClampAxis, 2> clamp_axes(const scene::Texture& texture);

/// The triangle cut along the bounds, each piece with coordinates within them; pieces without area are left
/// out.
std::vector<std::array<Corner, 3>> clamp_triangle(const std::array<Corner, 3>& triangle,
                                                  const std::array<ClampAxis, 2>& axes);

}  // namespace orbs::adapters::povray
