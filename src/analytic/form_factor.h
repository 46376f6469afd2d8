#pragma once

#include "base/vec.h"
#include "registry/analytic.h"

#include <vector>

/// Form factors: the share of the cosine-weighted hemisphere above a point that a shape covers, so that a
/// shape of radiance L gives the irradiance pi L F (Howell, Menguc and Siegel, Thermal Radiation Heat
/// Transfer, 2010, chapter 4).
namespace orbs::analytic {

using Corners = std::vector<Vec3d>;

/// The part of a convex polygon where dot(inward, corner) >= offset (Sutherland and Hodgman 1974). Empty when
/// nothing is left.
Corners clipped(const Corners& corners, Vec3d inward, double offset = 0);

/// What is left of a convex polygon, seen from the origin, where others are before it: convex pieces. The
/// plane of the polygon cuts the blockers, of which only what lies on the origin's side hides anything.
std::vector<Corners> unhidden(const Corners& corners, const std::vector<Corners>& blockers);

/// Whether the origin lies in the plane of a polygon, up to rounding: nothing of it is above its own points.
bool lies_in_plane(const Corners& corners);

/// Of a convex polygon whose corners are given relative to the point, above the horizon of the unit normal;
/// Lambert's sum over the edges (Baum, Rushmeier and Winget 1989, eq. 13). Never negative.
double polygon_form_factor(const Corners& corners, Vec3d normal);

/// Of a sphere that the point lies outside of, the horizon cutting it or not (Snyder 1996; derived by
/// projecting the cap's rim on the base plane). `centre` is relative to the point. Zero inside.
double sphere_form_factor(Vec3d centre, double radius, Vec3d normal);

/// Of a disk that is parallel to the surface, at height h above the point and a aside:
/// F = (1 - (a^2 + h^2 - r^2) / sqrt((a^2 + h^2 + r^2)^2 - 4 a^2 r^2)) / 2.
double parallel_disk_form_factor(double height, double aside, double radius);

/// What covers how much above a point with a unit normal, and whether its front is seen.
struct Coverage {
  double form_factor = 0;
  bool shows_front = false;
};

/// What a shape covers above the point, as far as it is seen through the window (no corners: everywhere) and
/// the blockers, which are given relative to the point, leave it visible; blockers hide polygons alone.
/// InputError for a disk that is not parallel to the surface: it has no closed form here.
Coverage coverage(const registry::AnalyticShape& shape,
                  const Corners& window,
                  const std::vector<Corners>& blockers,
                  Vec3d point,
                  Vec3d normal);

/// The corners relative to the point.
Corners seen_from(Vec3d point, const Corners& corners);

}  // namespace orbs::analytic
