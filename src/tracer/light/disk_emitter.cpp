#include "tracer/light/disk_emitter.h"

#include "tracer/accel/curved_surface.h"
#include "tracer/sampling/warps.h"

namespace orbs::tracer {

DiskEmitter make_emitter(const scene::DiskShape& disk, const Mat4& matrix, Vec3f normal) {
  DiskEmitter out{.centre = cast<float>(transform_point(matrix, {})),
                  .a = direction_of(matrix, {disk.radius_m, 0, 0}),
                  .b = direction_of(matrix, {0, 0, disk.radius_m}),
                  .normal = normal};
  out.area = kPi * length(cross(out.a, out.b));
  return out;
}

CurvedSurface surface_of(const DiskEmitter& disk) {
  const Vec3d a = cast<double>(disk.a);
  const Vec3d b = cast<double>(disk.b);
  // The normal only completes the basis; the disk has no extent along it.
  return {cast<double>(disk.centre),
          inverse_rows(a, cast<double>(disk.normal) * std::sqrt(length(a) * length(b)), b), false};
}

std::optional<EmitterPoint> sample_towards(const DiskEmitter& disk, Vec3f from, float u, float v) {
  const Vec2f at = sample_disk(u, v);
  return point_by_area(from, disk.centre + disk.a * at.x + disk.b * at.y, disk.normal, disk.area,
                       rounding_of(disk));
}

float pdf_towards(const DiskEmitter& disk, Vec3f from, Vec3f position) {
  return area_to_solid_angle(from, position, disk.normal, disk.area);
}

EmittingPoint point_on(const DiskEmitter& disk, float u, float v) {
  const Vec2f at = sample_disk(u, v);
  return {disk.centre + disk.a * at.x + disk.b * at.y, disk.normal, 1 / disk.area, rounding_of(disk), {}};
}

float pdf_area(const DiskEmitter& disk, Vec3f) { return 1 / disk.area; }

Vec3f normal_of(const DiskEmitter& disk, Vec3f) { return disk.normal; }

bool shows_bright_side(const DiskEmitter& disk, Vec3f, Vec3f to_viewer) {
  return dot(disk.normal, to_viewer) > 0;
}

float rounding_of(const DiskEmitter& disk) { return rounding_of(disk.centre, disk.a, disk.b); }

LightBounds bounds_of(const DiskEmitter& disk, float power) {
  return flat_bounds(disk.centre, root_of_squares(disk.a, disk.b), disk.normal, power);
}

}  // namespace orbs::tracer
