// A plug-in for orbs-tracer: the hyperbolic paraboloid z = k (x^2 - y^2) over the square |x|, |y| <=
// half_size. The normal points to larger z; u runs with x and v with y, both from 0 to 1.
#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <limits>
#include <new>

#include <orbs/shape_plugin.h>

struct orbs_shape {
  double half_size;  // m
  double k;          // 1 / m
};

namespace {

struct Point {
  double x;
  double y;
  double z;
};

Point point_at(const orbs_shape_ray& ray, double t) {
  return {ray.origin[0] + t * ray.direction[0], ray.origin[1] + t * ray.direction[1],
          ray.origin[2] + t * ray.direction[2]};
}

// Both t where the ray meets the surface without its edges, infinite or no number where there is none.
std::array<double, 2> roots(const orbs_shape& shape, const orbs_shape_ray& ray) {
  const auto& o = ray.origin;
  const auto& d = ray.direction;
  // k (x^2 - y^2) - z along the ray is a t^2 + b t + c.
  const double a = shape.k * (d[0] - d[1]) * (d[0] + d[1]);
  const double b = 2 * shape.k * (o[0] * d[0] - o[1] * d[1]) - d[2];
  const double c = shape.k * (o[0] - o[1]) * (o[0] + o[1]) - o[2];
  // The sum of equal signs does not cancel (Goldberg 1991, What Every Computer Scientist Should Know About
  // Floating-Point Arithmetic, 1.4). Where a is 0, the first quotient is infinite and the second the one
  // root.
  const double q = -0.5 * (b + std::copysign(std::sqrt(b * b - 4 * a * c), b));
  std::array<double, 2> t{q / a, c / q};
  // A step of Newton's takes the rounding of a, b and c out, which is that of the squares of far origins.
  for (double& root : t) {
    const Point p = point_at(ray, root);
    const double slope = 2 * shape.k * (p.x * d[0] - p.y * d[1]) - d[2];
    const double step = (shape.k * (p.x - p.y) * (p.x + p.y) - p.z) / slope;
    if (std::isfinite(step)) root -= step;
  }
  return t;
}

// The nearest root in the range of the ray over the square; infinite if there is none.
double nearest(const orbs_shape& shape, const orbs_shape_ray& ray) {
  double found = std::numeric_limits<double>::infinity();
  for (const double t : roots(shape, ray)) {
    if (!(t > ray.t_min && t < ray.t_max && t < found)) continue;  // also where t is no number
    const Point p = point_at(ray, t);
    if (std::fabs(p.x) <= shape.half_size && std::fabs(p.y) <= shape.half_size) found = t;
  }
  return found;
}

}  // namespace

uint32_t orbs_shape_plugin_version() { return ORBS_SHAPE_PLUGIN_VERSION; }

orbs_shape* orbs_shape_create(const orbs_shape_number* numbers,
                              size_t count,
                              char* problem,
                              size_t problem_size) {
  orbs_shape shape{1, 1};
  for (size_t i = 0; i < count; ++i) {
    const bool is_half_size = std::strcmp(numbers[i].name, "half_size") == 0;
    if (!is_half_size && std::strcmp(numbers[i].name, "k") != 0) {
      std::snprintf(problem, problem_size, "there is no number '%s'; a saddle has half_size and k",
                    numbers[i].name);
      return nullptr;
    }
    (is_half_size ? shape.half_size : shape.k) = numbers[i].value;
  }
  if (!(shape.half_size > 0)) {
    std::snprintf(problem, problem_size, "half_size must be above 0, is %g", shape.half_size);
    return nullptr;
  }
  return new (std::nothrow) orbs_shape(shape);
}

void orbs_shape_destroy(orbs_shape* shape) { delete shape; }

void orbs_shape_bounds(const orbs_shape* shape, double low[3], double high[3]) {
  const double height = std::fabs(shape->k) * shape->half_size * shape->half_size;
  const std::array<double, 3> reach{shape->half_size, shape->half_size, height};
  for (size_t axis = 0; axis < 3; ++axis) {
    low[axis] = -reach[axis];
    high[axis] = reach[axis];
  }
}

int orbs_shape_intersect(const orbs_shape* shape, const orbs_shape_ray* ray, orbs_shape_hit* hit) {
  const double t = nearest(*shape, *ray);
  if (!std::isfinite(t)) return 0;
  const Point p = point_at(*ray, t);
  hit->t = t;
  hit->normal[0] = -2 * shape->k * p.x;
  hit->normal[1] = 2 * shape->k * p.y;
  hit->normal[2] = 1;
  hit->uv[0] = 0.5 + 0.5 * p.x / shape->half_size;
  hit->uv[1] = 0.5 + 0.5 * p.y / shape->half_size;
  return 1;
}

int orbs_shape_occluded(const orbs_shape* shape, const orbs_shape_ray* ray) {
  return std::isfinite(nearest(*shape, *ray)) ? 1 : 0;
}

// Uniform over the square that the surface lies over. An area of the surface is larger than that below it by
// the length of the normal (-2 k x, 2 k y, 1).
void orbs_shape_pdf(const orbs_shape* shape, const double position[3], orbs_shape_sample_point* point) {
  const double x = position[0];
  const double y = position[1];
  point->position[0] = x;
  point->position[1] = y;
  point->position[2] = shape->k * (x - y) * (x + y);
  point->normal[0] = -2 * shape->k * x;
  point->normal[1] = 2 * shape->k * y;
  point->normal[2] = 1;
  const double slope = 2 * shape->k * std::hypot(x, y);
  point->pdf = 1 / (4 * shape->half_size * shape->half_size * std::hypot(1, slope));
}

int orbs_shape_sample(const orbs_shape* shape, const double random[2], orbs_shape_sample_point* point) {
  const std::array<double, 3> position{(2 * random[0] - 1) * shape->half_size,
                                       (2 * random[1] - 1) * shape->half_size, 0};
  orbs_shape_pdf(shape, position.data(), point);
  return 1;
}
