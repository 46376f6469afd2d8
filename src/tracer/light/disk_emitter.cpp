#include "tracer/light/disk_emitter.h"

#include "tracer/accel/curved_surface.h"
#include "tracer/sampling/warps.h"

namespace orbs::tracer {

namespace {

Vec3f place(const DiskEmitter& disk, float u, float v) {
  const Vec2f at = sample_disk(u, v);
  return cast<float>(disk.centre + disk.a * static_cast<double>(at.x) + disk.b * static_cast<double>(at.y));
}

}  // namespace

DiskEmitter make_emitter(const scene::DiskShape& disk, const Mat4& matrix, Vec3d normal) {
  DiskEmitter out{.centre = transform_point(matrix, {}),
                  .a = transform_direction(matrix, {disk.radius_m, 0, 0}),
                  .b = transform_direction(matrix, {0, 0, disk.radius_m}),
                  .normal = normal};
  out.area = kPi * static_cast<float>(length(cross(out.a, out.b)));
  return out;
}

CurvedSurface surface_of(const DiskEmitter& disk) {
  // The normal only completes the basis; the disk has no extent along it.
  const Vec3d across = disk.normal * std::sqrt(length(disk.a) * length(disk.b));
  return {disk.centre, inverse_rows(disk.a, across, disk.b), false};
}

std::optional<EmitterPoint> sample_towards(const DiskEmitter& disk, Vec3f from, float u, float v) {
  return point_by_area(from, place(disk, u, v), cast<float>(disk.normal), disk.area, rounding_of(disk));
}

float pdf_towards(const DiskEmitter& disk, Vec3f from, Vec3f position) {
  return area_to_solid_angle(from, position, cast<float>(disk.normal), disk.area);
}

EmittingPoint point_on(const DiskEmitter& disk, float u, float v) {
  return {place(disk, u, v), cast<float>(disk.normal), 1 / disk.area, rounding_of(disk), {}};
}

float pdf_area(const DiskEmitter& disk, Vec3f) { return 1 / disk.area; }

Vec3f normal_of(const DiskEmitter& disk, Vec3f) { return cast<float>(disk.normal); }

bool shows_bright_side(const DiskEmitter& disk, Vec3f, Vec3f to_viewer) {
  return dot(disk.normal, cast<double>(to_viewer)) > 0;
}

float rounding_of(const DiskEmitter& disk) { return rounding_of(disk.centre, disk.a, disk.b); }

LightBounds bounds_of(const DiskEmitter& disk, float power) {
  return flat_bounds(cast<float>(disk.centre), root_of_squares(cast<float>(disk.a), cast<float>(disk.b)),
                     cast<float>(disk.normal), power);
}

}  // namespace orbs::tracer
