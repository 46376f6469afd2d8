/* Shapes that a plug-in brings to orbs-tracer.
 *
 * A plug-in is a shared library that defines the functions below with C linkage. This header is all that it
 * needs: it is C and C++, includes nothing of orbs, and the library is linked with nothing of orbs.
 * orbs-tracer opens the library when a scene names it:
 *
 *   {"type": "plugin", "plugin": "saddle", "numbers": {"half_size": 0.5}, "material": "red", "matrix": [...]}
 *
 * and calls, in this order: orbs_shape_plugin_version once; orbs_shape_create for each such shape of the
 * scene; orbs_shape_bounds once per shape; orbs_shape_intersect and orbs_shape_occluded for rays, from many
 * threads at once; orbs_shape_destroy.
 *
 * Space. All places, directions and sizes are in the shape's own space, in metres before the `matrix` of the
 * scene. The tracer turns rays into this space and normals back, so a plug-in never sees the matrix. All
 * numbers are doubles.
 *
 * Rules. The functions share no state that changes, so that the image does not depend on threads: the same
 * ray gets the same answer, to the bit. They throw nothing and end in finite time. They run inside of the
 * tracer: a plug-in that crashes ends the render, and a plug-in can do all that its user can do. Use none
 * that you do not trust.
 */
#ifndef ORBS_SHAPE_PLUGIN_H
#define ORBS_SHAPE_PLUGIN_H

#include <stddef.h>
#include <stdint.h>

/* Raised with every change of this header that a compiled plug-in would notice. orbs-tracer opens plug-ins of
 * its own version only. */
#define ORBS_SHAPE_PLUGIN_VERSION 1

/* Shown by the library also where it hides its other symbols. */
#define ORBS_SHAPE_PLUGIN_API __attribute__((visibility("default")))

#if defined(__cplusplus)
extern "C" {
#endif

/* The plug-in's own data of one shape. */
typedef struct orbs_shape orbs_shape;

/* One of the scene's `numbers`. */
typedef struct orbs_shape_number {
  const char* name; /* letters, digits, '-' and '_' */
  double value;     /* finite */
} orbs_shape_number;

/* The points origin + t direction with t_min < t < t_max. The direction has any length but zero. t_max may be
 * infinite. */
typedef struct orbs_shape_ray {
  double origin[3];
  double direction[3];
  double t_min; /* not negative */
  double t_max;
} orbs_shape_ray;

typedef struct orbs_shape_hit {
  double t;         /* t_min < t < t_max */
  double normal[3]; /* of any length but zero; its side is the outside of the shape */
  double uv[2];     /* texture coordinates */
} orbs_shape_hit;

/* A point of the surface, chosen at random. */
typedef struct orbs_shape_sample_point {
  double position[3];
  double normal[3]; /* as in orbs_shape_hit */
  double pdf;       /* probability density per area at this point, in 1 / m^2 */
} orbs_shape_sample_point;

/* Required. Returns ORBS_SHAPE_PLUGIN_VERSION. */
ORBS_SHAPE_PLUGIN_API uint32_t orbs_shape_plugin_version(void);

/* Required. A new shape from the numbers of the scene, in the order of their names. A number that is missing,
 * unknown or out of range is refused: write what is wrong into `problem`, which has room for `problem_size`
 * bytes with the closing zero, and return NULL. The tracer shows it with the place in the scene. */
ORBS_SHAPE_PLUGIN_API orbs_shape* orbs_shape_create(const orbs_shape_number* numbers,
                                                    size_t count,
                                                    char* problem,
                                                    size_t problem_size);

/* Required. Frees the shape. */
ORBS_SHAPE_PLUGIN_API void orbs_shape_destroy(orbs_shape* shape);

/* Required. A box along the axes that holds the whole surface: finite, low[i] <= high[i]. */
ORBS_SHAPE_PLUGIN_API void orbs_shape_bounds(const orbs_shape* shape, double low[3], double high[3]);

/* Required. 1 and the nearest point within the range of the ray that lies on the surface, or 0 if there is
 * none. A hit that is not as orbs_shape_hit says, or lies outside of the bounds, counts as none, and the
 * image says how many there were. */
ORBS_SHAPE_PLUGIN_API int orbs_shape_intersect(const orbs_shape* shape,
                                               const orbs_shape_ray* ray,
                                               orbs_shape_hit* hit);

/* Optional. 1 if any point within the range of the ray lies on the surface, else 0. Shadow rays ask this, as
 * any hit is found faster than the nearest one. Without this function they ask orbs_shape_intersect. */
ORBS_SHAPE_PLUGIN_API int orbs_shape_occluded(const orbs_shape* shape, const orbs_shape_ray* ray);

/* Optional. A point of the surface for two random numbers in [0, 1): 1, or 0 if the shape cannot be sampled.
 * Every point of the surface must be possible, up to its edges. A glowing shape is sampled as a lamp where
 * the plug-in has this function and the next one, and its emission has no texture. Its light is found by
 * sampling BSDFs alone otherwise, which is right, too, and noisier. */
ORBS_SHAPE_PLUGIN_API int orbs_shape_sample(const orbs_shape* shape,
                                            const double random[2],
                                            orbs_shape_sample_point* point);

/* Optional. For a point of the surface, which may be off it by rounding: `point` as orbs_shape_sample gives
 * it when it chooses this point. */
ORBS_SHAPE_PLUGIN_API void orbs_shape_pdf(const orbs_shape* shape,
                                          const double position[3],
                                          orbs_shape_sample_point* point);

#if defined(__cplusplus)
}
#endif

#endif
