#pragma once

#include "base/matrix.h"
#include "base/vec.h"

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace orbs::scene {

/// Intensity distribution of a light, LM-63 type C: candela over (vertical, horizontal) angle with
/// symmetry unfolded.
struct IesProfile {
  std::vector<double> vertical_deg;    // ascending within [0, 180]; 0 = nadir = local -Y of the light
  std::vector<double> horizontal_deg;  // ascending; first 0, last 360; 0 = local +X, 90 = local +Z
  std::vector<double> candela;         // [horizontal][vertical]
  double max_candela = 0;
  bool operator==(const IesProfile&) const = default;
};

/// The light's radiance is multiplied by candela / max candela.
struct IesUse {
  std::filesystem::path file;  // absolute
  std::shared_ptr<const IesProfile> profile;
  Mat4 matrix;  // turns the profile within the light's local frame
  /// true: the direction is taken from the light's centre (ORB.S REQ_L4, point-area); false: from the point
  /// on the light.
  bool point_area = false;
  bool operator==(const IesUse& other) const {
    return file == other.file && *profile == *other.profile && matrix == other.matrix &&
           point_area == other.point_area;
  }
};

/// Reads an IES LM-63 photometric file (1986 to 2002, type C) with the symmetry of its horizontal range
/// unfolded to 0..360. Candela include the multiplier, the ballast factor and the tilt factor at level
/// mounting; lamp lumens do not multiply. InputError naming the file for type A or B, external TILT files,
/// missing or superfluous numbers, angles that do not ascend, planes that end where no symmetry says what
/// the rest of the circle has.
IesProfile parse_ies(const std::string& name, std::string_view text);

/// Candela towards (vertical, horizontal) in degrees, bilinear; 0 outside the stored vertical range.
/// `horizontal_deg` is taken modulo 360.
double candela_at(const IesProfile& profile, double vertical_deg, double horizontal_deg);

/// Candela towards a unit direction in the light's local frame: vertical 0 is -Y, horizontal 0 is +X and 90
/// is +Z. LM-63 does not say from which side the azimuth of type C counts; this is our choice, and the
/// scene's `matrix` can turn it.
double candela_towards(const IesProfile& profile, Vec3d local_direction);

}  // namespace orbs::scene
