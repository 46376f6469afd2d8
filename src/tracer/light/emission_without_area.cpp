#include "tracer/light/emission_without_area.h"

#include "tracer/geometry/transforms.h"
#include "tracer/sampling/warps.h"

#include <algorithm>

namespace orbs::tracer {

namespace {

struct StartTowardsCasters {
  const std::vector<BoundingSphere>& casters;
  std::size_t chosen;
  float u;
  float v;

  // Of all casters alike, by pdf_of(caster, was_chosen).
  template <typename Pdf>
  float mean_pdf(const Pdf& pdf_of) const {
    float sum = 0;
    for (std::size_t i = 0; i < casters.size(); ++i) sum += pdf_of(casters[i], i == chosen);
    return sum / static_cast<float>(casters.size());
  }

  StartWithoutArea from_point(Vec3f position) const {
    const Vec3f direction = direction_towards(casters[chosen], position, u, v);
    return {position, direction, mean_pdf([&](const BoundingSphere& caster, bool was_chosen) {
              return pdf_towards(caster, position, direction, was_chosen);
            })};
  }
  StartWithoutArea operator()(const PointEmitter& point) const { return from_point(point.position); }
  StartWithoutArea operator()(const SpotEmitter& spot) const { return from_point(spot.position); }

  // Uniform on the disk that the caster's sphere shows to the light.
  StartWithoutArea operator()(const DirectionalEmitter& light) const {
    const Frame frame = frame_around(light.direction);
    const Vec2f at = sample_disk(u, v);
    const BoundingSphere& target = casters[chosen];
    const Vec3f passed = target.centre + (frame.x * at.x + frame.y * at.y) * target.radius;
    const float pdf = mean_pdf([&](const BoundingSphere& caster, bool was_chosen) {
      const bool meets =
          was_chosen || length(cross(passed - caster.centre, light.direction)) <= caster.radius;
      return meets ? 1 / (kPi * caster.radius * caster.radius) : 0;
    });
    return {passed - light.direction * reach(light), light.direction, pdf};
  }

  template <typename Emitter>
  StartWithoutArea operator()(const Emitter&) const {
    return {};
  }
};

}  // namespace

StartWithoutArea start_towards_casters(
    const AreaLight& light, const std::vector<BoundingSphere>& casters, float pick, float u, float v) {
  const auto count = casters.size();
  const auto chosen = std::min(static_cast<std::size_t>(pick * static_cast<float>(count)), count - 1);
  return std::visit(StartTowardsCasters{casters, chosen, u, v}, light.shape);
}

}  // namespace orbs::tracer
