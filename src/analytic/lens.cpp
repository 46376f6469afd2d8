#include "analytic/lens.h"

#include "base/error.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>
#include <vector>

namespace orbs::analytic {

namespace {

// The part of the disk between the origin and the segment, counted by its turn: of a sector where the segment
// lies outside, of a triangle where it lies inside.
double area_below_edge(Vec3d a, Vec3d b, double radius) {
  const auto sector = [&](Vec3d from, Vec3d to) {
    return radius * radius / 2 * std::atan2(from.x * to.y - from.y * to.x, from.x * to.x + from.y * to.y);
  };
  const auto triangle = [](Vec3d from, Vec3d to) { return (from.x * to.y - from.y * to.x) / 2; };
  const Vec3d along = b - a;
  const double square = dot(along, along);
  if (square == 0) return 0;
  const double middle = -dot(a, along) / square;
  const Vec3d nearest = a + along * middle;
  const double inside = radius * radius - dot(nearest, nearest);
  if (inside <= 0) return sector(a, b);
  const double half = std::sqrt(inside / square);
  const double enters = std::clamp(middle - half, 0.0, 1.0);
  const double leaves = std::clamp(middle + half, 0.0, 1.0);
  const Vec3d first = a + along * enters;
  const Vec3d last = a + along * leaves;
  return sector(a, first) + triangle(first, last) + sector(last, b);
}

constexpr double kInFocus = 1e-6;  // of the distance: the blur is then a millionth of the lens

// What is seen of a surface from the point in focus, in the plane of the lens: a ray from a point of it
// through the point in focus meets the surface.
struct LensPart {
  Corners corners;  // z = 0
  const GlowingPolygon* surface = nullptr;
};

Corners on_lens(Corners corners, Vec3d focus) {
  for (Vec3d& corner : corners) {
    corner = focus + (corner - focus) * (focus.z / (focus.z - corner.z));
    corner.z = 0;
  }
  return corners;
}

bool is_inside(const Corners& corners, Vec3d normal, Vec3d point) {
  for (std::size_t i = 0; i < corners.size(); ++i)
    if (dot(cross(corners[(i + 1) % corners.size()] - corners[i], point - corners[i]), normal) < 0)
      return false;
  return true;
}

// Calls visit(inward, offset) for each side of a convex polygon of the plane z = 0, of which no edge is too
// short to have a direction.
template <typename F>
void for_each_side(const Corners& corners, const F& visit) {
  double turn = 0;
  for (std::size_t i = 0; i < corners.size(); ++i)
    turn += cross(corners[i], corners[(i + 1) % corners.size()]).z;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec3d edge = corners[(i + 1) % corners.size()] - corners[i];
    const Vec3d inward = Vec3d{-edge.y, edge.x, 0} * (turn > 0 ? 1.0 : -1.0);
    if (length(inward) > 0) visit(normalised(inward), dot(normalised(inward), corners[i]));
  }
}

// What a point of the image sees through the lens.
class LensParts {
 public:
  LensParts(double radius, Vec3d focus) : radius_(radius), focus_(focus) {}

  void add(const GlowingPolygon& surface) {
    if (surface.is_in_focus && is_inside(surface.corners, surface.normal, focus_)) {
      const double far = 2 * radius_;
      parts_.push_back({{{-far, -far, 0}, {far, -far, 0}, {far, far, 0}, {-far, far, 0}}, &surface});
    }
    for (const Corners* corners : {&surface.before, &surface.beyond})
      if (corners->size() >= 3) add_if_seen({on_lens(*corners, focus_), &surface});
  }

  double seen(double environment) const {
    const double disk = std::numbers::pi * radius_ * radius_;
    double sum = environment;
    for (const LensPart& part : parts_)
      for (const Corners& piece : unhidden_pieces(part))
        sum += (part.surface->radiance - environment) * std::fabs(area_in_disk(piece, radius_)) / disk;
    return std::fmax(0.0, sum);  // below zero by rounding alone: the shares of the disk add up to 1
  }

 private:
  // Unless all of the lens lies on the outer side of an edge.
  void add_if_seen(LensPart part) {
    bool is_seen = true;
    for_each_side(part.corners, [&](Vec3d, double offset) { is_seen = is_seen && offset < radius_; });
    if (is_seen) parts_.push_back(std::move(part));
  }

  double distance_to(const LensPart& part, Vec3d lens_point) const {
    const auto& [normal, corners] = std::tie(part.surface->normal, part.surface->corners);
    return dot(normal, corners.front() - lens_point) / dot(normal, focus_ - lens_point);
  }

  // Surfaces do not cross, so one hides the other wherever they overlap, and both parts are convex.
  bool hides(const LensPart& other, const LensPart& part) const {
    Corners common = part.corners;
    for_each_side(other.corners, [&](Vec3d inward, double offset) {
      if (common.size() >= 3) common = clipped(common, inward, offset);
    });
    if (common.size() < 3) return false;
    Vec3d middle;
    for (const Vec3d corner : common) middle += corner / static_cast<double>(common.size());
    return distance_to(other, middle) < distance_to(part, middle);
  }

  std::vector<Corners> unhidden_pieces(const LensPart& part) const {
    std::vector<Corners> pieces{part.corners};
    for (const LensPart& other : parts_) {
      if (&other == &part || !hides(other, part)) continue;
      std::vector<Corners> left;
      for (Corners& rest : pieces)
        for_each_side(other.corners, [&](Vec3d inward, double offset) {
          if (rest.size() < 3) return;
          if (auto outside = clipped(rest, -inward, -offset); outside.size() >= 3)
            left.push_back(std::move(outside));
          rest = clipped(rest, inward, offset);
        });
      pieces = std::move(left);
    }
    return pieces;
  }

  double radius_;
  Vec3d focus_;
  std::vector<LensPart> parts_;
};

}  // namespace

double area_in_disk(const Corners& corners, double radius) {
  double sum = 0;
  for (std::size_t i = 0; i < corners.size(); ++i)
    sum += area_below_edge(corners[i], corners[(i + 1) % corners.size()], radius);
  return sum;
}

ThinLensImage::ThinLensImage(const registry::DirectLight& image, const scene::Camera& camera)
    : camera_(camera), frame_(scene::camera_frame(camera)), environment_(image.environment) {
  for (const auto& surface : image.surfaces) {
    const auto* polygon = std::get_if<registry::FlatPolygon>(&surface.shape);
    if (polygon == nullptr || surface.reflectance || image.shutter)
      throw InputError(
          "the formula 'direct_light' is known through a lens for glowing polygons at rest alone");
    add(polygon->corners, surface.radiance);
  }
}

Vec3d ThinLensImage::in_frame(Vec3d v) const {
  return {dot(v, frame_.right), dot(v, frame_.up), dot(v, frame_.forward)};
}

void ThinLensImage::add(const std::vector<Vec3d>& world, double radiance) {
  GlowingPolygon made;
  for (const Vec3d corner : world) made.corners.push_back(in_frame(corner - camera_.position_m));
  const auto& corners = made.corners;
  made.normal = cross(corners[1] - corners[0], corners[2] - corners[0]);
  // Black from behind. The frame is left-handed, so that the product is the front's from the other side.
  made.radiance = dot(made.normal, corners[0]) > 0 ? radiance : 0;
  const double focus = camera_.focus_distance_m.value();
  const double low = focus * (1 - kInFocus);
  const double high = focus * (1 + kInFocus);
  made.is_in_focus =
      std::all_of(corners.begin(), corners.end(), [&](Vec3d c) { return c.z >= low && c.z <= high; });
  if (!made.is_in_focus) {
    made.before = clipped(clipped(corners, {0, 0, 1}, kInFocus * focus), {0, 0, -1}, -low);
    made.beyond = clipped(corners, {0, 0, 1}, high);
  }
  polygons_.push_back(std::move(made));
}

double ThinLensImage::at(double x, double y) const {
  const Vec3d along = in_frame(scene::camera_ray(camera_, frame_, x, y).direction);
  LensParts parts(camera_.aperture_radius_m, along * (camera_.focus_distance_m.value() / along.z));
  for (const auto& polygon : polygons_) parts.add(polygon);
  return parts.seen(environment_);
}

}  // namespace orbs::analytic
