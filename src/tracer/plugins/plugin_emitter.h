#pragma once

#include "tracer/light/emitter_type.h"
#include "tracer/plugins/plugin_shape.h"

#include <optional>

/// Glowing shapes of plug-ins that light sampling can choose points on.
namespace orbs::tracer {

struct PluginEmitter {
  std::size_t shape = 0;  // index into World::plugin_shapes
  float area_m2 = 0;      // estimated by its own samples; used for selection only
};

/// A random point of the surface, in world space.
struct PluginPoint {
  Vec3d position;
  Vec3d normal;         // unit
  double pdf_area = 0;  // per m^2
};

/// Whether the plug-in has both functions that it takes: orbs_shape_sample and orbs_shape_pdf. Without the
/// second nobody knows how probable a point was that a ray has found.
bool can_be_sampled(const PluginShape& shape);

/// For random numbers in [0, 1). Nothing if the shape cannot be sampled, or breaks the rules, which is
/// counted.
std::optional<PluginPoint> sampled_point(const PluginShape& shape, double u, double v);

/// The point of the surface at this place, with the density with which sampled_point chooses it. Nothing if
/// the plug-in breaks the rules, which is counted.
std::optional<PluginPoint> point_at(const PluginShape& shape, Vec3d position);

/// Estimate of the area in m^2 by some hundred samples; 0 if the shape cannot be sampled. InputError if both
/// functions give different densities.
float sampled_area(const PluginShape& shape);

/// Bound of the rounding error of a sampled point, as a float, in metres.
float rounding_of(const PluginShape& shape);

/// As those of EmitterType. The surface shines to both sides, each of which a light path leaves with
/// probability 1/2.
std::optional<EmitterPoint> sample_towards(const PluginShape& shape, Vec3f from, float u, float v);
float pdf_towards(const PluginShape& shape, Vec3f from, Vec3f position);
/// Where the plug-in has no point, its density is infinite, so that a light path from there carries nothing.
EmittingPoint point_on(const PluginShape& shape, float u, float v, float side);
float pdf_area(const PluginShape& shape, Vec3f position);
Vec3f normal_of(const PluginShape& shape, Vec3f position);
LightBounds light_bounds_of(const PluginShape& shape, float power);

}  // namespace orbs::tracer
