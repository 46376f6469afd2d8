#pragma once

#include "base/vec.h"
#include "scene/scene.h"

#include <array>

/// Records of the irradiance cache, and how far each may be used.
namespace orbs::tracer {

/// A place where irradiance is asked for. World space.
struct SurfaceElement {
  Vec3f position;
  float position_error = 0;  // bound of its rounding, in metres
  Vec3f normal;              // unit shading normal, on the lit side
};

/// Irradiance that was computed at one place.
struct IrradianceRecord {
  SurfaceElement at;
  Vec3f irradiance;
  std::array<Vec3f, 3> translation_gradient;  // as in HemisphereEstimate, in world space
  std::array<Vec3f, 3> rotation_gradient;
  /// R_i, in metres: how far away the surfaces are that it sees. Ward: harmonic mean of the ray lengths;
  /// Tabellion and Lamorlette: the shortest one.
  float distance = 0;
  float least_spacing = 0;  // R-, in metres: bounds of the distance that the record reaches
  float most_spacing = 0;   // R+
};

/// As reach, without the bounds R- and R+.
float unbounded_reach(const scene::IrradianceCache& settings, float distance);

/// Distance within which the record may be used on a flat surface, in metres. Ward, Rubinstein and Clear 1988
/// (error a): a R_i between R- and R+. Tabellion and Lamorlette 2004: R_i / 2 between R- and R+, over kappa.
float reach(const scene::IrradianceCache& settings, const IrradianceRecord& record);

/// Error estimate of the record at a place, over the one that is allowed: it may be used below 1. With D the
/// reach of the record, Ward: |p - p_i| / D + sqrt(1 - n n_i) / a. Tabellion and Lamorlette: the larger of
/// |p - p_i| / D and kappa sqrt(1 - n n_i) / sqrt(1 - cos 10 deg).
float relative_error(const scene::IrradianceCache& settings,
                     const IrradianceRecord& record,
                     const SurfaceElement& at);

/// True if the place lies behind the surface of the record, which sees other light then (Ward, Rubinstein and
/// Clear 1988): (p - p_i) (n + n_i) / 2 is negative by more than rounding and a dip of 1 degree.
bool is_behind(const IrradianceRecord& record, const SurfaceElement& at);

/// Weight of a record with this relative error in (0, 1): zero at 1, so that no edge shows where its reach
/// ends. Ward: 1 / e - 1. Tabellion and Lamorlette: 1 - e.
float record_weight(const scene::IrradianceCache& settings, float relative_error);

/// E_i + (n_i x n) rotation_gradient + (p - p_i) translation_gradient, in each channel; may be negative.
Vec3f extrapolated(const IrradianceRecord& record, const SurfaceElement& at);

/// Limits the distance R_i to the mean irradiance over the length of its translation gradient: extrapolation
/// by a share a of R_i then changes the irradiance by this share at most (Krivanek and Gautron 2009).
/// Where R- makes the record reach farther than that, the gradient is scaled down to that share: close
/// to other surfaces noise over a short ray would lead anywhere.
void limit_by_gradient(const scene::IrradianceCache& settings, IrradianceRecord& record);

}  // namespace orbs::tracer
