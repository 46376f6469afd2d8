// A plug-in for tests: the square y = 0, |x|, |z| <= 1, which breaks the rule that its number "fault" names.
// 0 breaks none.
#include <cmath>
#include <cstdlib>
#include <limits>

#include <orbs/shape_plugin.h>

struct orbs_shape {
  int fault;
};

namespace {

enum Fault {
  kNone,
  kNanDistance,
  kNegativeDistance,
  kDistanceBeyond,
  kZeroNormal,
  kNanNormal,
  kNanUv,
  kOutsideBounds,
  kChanging,
  kCrash,
  kInfiniteBounds,
  kTurnedBounds,
  kNoShape,
  kExit,
  kSampleOutside,
  kSampleWithoutDensity,
  kTwoDensities,
};

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

}  // namespace

uint32_t orbs_shape_plugin_version() { return ORBS_SHAPE_PLUGIN_VERSION; }

orbs_shape* orbs_shape_create(const orbs_shape_number* numbers, size_t count, char*, size_t) {
  const int fault = count == 0 ? 0 : static_cast<int>(numbers[0].value);
  return fault == kNoShape ? nullptr : new orbs_shape{fault};
}

void orbs_shape_destroy(orbs_shape* shape) { delete shape; }

void orbs_shape_bounds(const orbs_shape* shape, double low[3], double high[3]) {
  for (int axis = 0; axis < 3; ++axis) {
    const double reach = axis == 1 ? 0 : shape->fault == kOutsideBounds ? 0.5 : 1;
    low[axis] = -reach;
    high[axis] = reach;
  }
  if (shape->fault == kInfiniteBounds) high[0] = std::numeric_limits<double>::infinity();
  if (shape->fault == kTurnedBounds) low[2] = 2;
}

int orbs_shape_intersect(const orbs_shape* shape, const orbs_shape_ray* ray, orbs_shape_hit* hit) {
  if (shape->fault == kCrash) std::abort();
  if (shape->fault == kExit) std::exit(0);
  const double t = -ray->origin[1] / ray->direction[1];
  const double x = ray->origin[0] + t * ray->direction[0];
  const double z = ray->origin[2] + t * ray->direction[2];
  if (!(t > ray->t_min && t < ray->t_max && std::fabs(x) <= 1 && std::fabs(z) <= 1)) return 0;
  *hit = {t, {0, 2, 0}, {x, z}};
  switch (shape->fault) {
    case kNanDistance:
      hit->t = kNan;
      break;
    case kNegativeDistance:
      hit->t = -t;
      break;
    case kDistanceBeyond:
      hit->t = ray->t_max;
      break;
    case kZeroNormal:
      hit->normal[1] = 0;
      break;
    case kNanNormal:
      hit->normal[2] = kNan;
      break;
    case kNanUv:
      hit->uv[1] = kNan;
      break;
    case kChanging: {
      static thread_local int asked = 0;
      if (++asked % 2 == 0) return 0;
      break;
    }
    default:
      break;
  }
  return 1;
}

void orbs_shape_pdf(const orbs_shape* shape, const double position[3], orbs_shape_sample_point* point) {
  *point = {{position[0], 0, position[2]}, {0, 1, 0}, shape->fault == kTwoDensities ? 0.5 : 0.25};
}

int orbs_shape_sample(const orbs_shape* shape, const double random[2], orbs_shape_sample_point* point) {
  *point = {{2 * random[0] - 1, 0, 2 * random[1] - 1}, {0, 1, 0}, 0.25};
  if (shape->fault == kSampleOutside) point->position[1] = 1;
  if (shape->fault == kSampleWithoutDensity) point->pdf = 0;
  return 1;
}
