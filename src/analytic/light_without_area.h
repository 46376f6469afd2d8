#pragma once

#include "registry/analytic.h"

namespace orbs::analytic {

/// Between the rows of a table of degrees from -y, as LM-63 profiles are read; black beyond its ends.
double candela_towards(const std::vector<std::pair<double, double>>& rows, Vec3d direction);

/// The irradiance at a point of a surface with this unit normal that the lights without an area send: I cos /
/// d^2 of one at a place, E cos of one from afar.
double irradiance_of_lights(const registry::DirectLight& image,
                            Vec3d point,
                            Vec3d normal,
                            Vec3d shading_normal);

}  // namespace orbs::analytic
