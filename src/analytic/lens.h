#pragma once

#include "analytic/form_factor.h"
#include "registry/analytic.h"
#include "scene/camera_frame.h"

#include <vector>

namespace orbs::analytic {

/// In the frame of the camera: right, up, forward.
struct GlowingPolygon {
  Corners corners;
  Corners before;  // what lies before the plane in focus, and beyond it
  Corners beyond;
  Vec3d normal;  // need not be unit
  double radiance = 0;
  bool is_in_focus = false;  // all of it
};

/// What a thin lens shows of glowing polygons that do not cross each other, each by its share of the disk.
/// Seen from the point in focus, polygons are polygons of the plane of the lens too, so their shares are
/// exact. A polygon shows the side that the middle of the lens sees. InputError where a surface is no
/// polygon, is lit or moves: nothing else has a closed form.
class ThinLensImage {
 public:
  ThinLensImage(const registry::DirectLight& image, const scene::Camera& camera);

  /// The radiance at a point of the image, in pixels from its upper left corner.
  double at(double x, double y) const;

 private:
  Vec3d in_frame(Vec3d v) const;
  void add(const std::vector<Vec3d>& world, double radiance);

  scene::Camera camera_;
  scene::CameraFrame frame_;
  double environment_;
  std::vector<GlowingPolygon> polygons_;
};

/// Area of a convex polygon of the plane z = 0 that lies in the disk around the origin, below 0 where it runs
/// clockwise: by the parts of the sectors below its edges.
double area_in_disk(const Corners& corners, double radius);

}  // namespace orbs::analytic
