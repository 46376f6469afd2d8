#pragma once

#include "scene/scene.h"

#include <string>
#include <string_view>

namespace orbs::scene {

/// Reads an IES LM-63 photometric file (1986 to 2002, type C) with the symmetry of its horizontal range
/// unfolded to 0..360. Candela include the multiplier, the ballast factor and the tilt factor at level
/// mounting; lamp lumens do not multiply. InputError naming the file for type A or B, external TILT files,
/// missing or superfluous numbers, angles that do not ascend.
IesProfile parse_ies(const std::string& name, std::string_view text);

/// Candela towards (vertical, horizontal) in degrees, bilinear; 0 outside the stored vertical range.
/// `horizontal_deg` is taken modulo 360.
double candela_at(const IesProfile& profile, double vertical_deg, double horizontal_deg);

/// Candela towards a unit direction in the light's local frame: vertical 0 is -Y, horizontal 0 is +X and 90
/// is +Z. LM-63 does not say from which side the azimuth of type C counts; this is our choice, and the
/// scene's `matrix` can turn it.
double candela_towards(const IesProfile& profile, Vec3d local_direction);

}  // namespace orbs::scene
