#include "scene/lights/disk.h"

#include "json/writer.h"
#include "scene/lights/placement.h"
#include "scene/load/entry.h"

#include <numbers>

namespace orbs::scene {

void load(json::ObjectReader& in, DiskShape& loaded) { loaded.radius_m = in.number("radius", kLength); }

void write(json::Writer& out, const DiskShape& disk) { out.member("radius", disk.radius_m); }

Vec3d half_size(const DiskShape& disk) { return {disk.radius_m, 0, disk.radius_m}; }

double cross_section_m2(const DiskShape& disk) { return std::numbers::pi * disk.radius_m * disk.radius_m; }

std::optional<DiskShape> absorbed(const DiskShape& disk, const Mat4& matrix) {
  const auto scale = level_scale(matrix);
  return scale ? std::optional(DiskShape{disk.radius_m * *scale}) : std::nullopt;
}

LightHit hit(const DiskShape& disk, Vec3d origin, Vec3d direction) {
  return flat_hit(origin, direction,
                  [&](double x, double z) { return x * x + z * z <= disk.radius_m * disk.radius_m; });
}

}  // namespace orbs::scene
