#include "analytic/polarised_planes.h"

#include "analytic/reflectance.h"

#include <cmath>
#include <complex>
#include <cstddef>
#include <vector>

// The light is its coherency matrix <E E*> in the axes of the world (Born and Wolf, Principles of Optics, 7th
// edition, 10.9, for all three components of the field), which a surface multiplies by a matrix of its own
// from both sides (Yun, Crabtree and Chipman, Three-dimensional polarization ray-tracing calculus I, Applied
// Optics 50, 2011). So there are no Mueller matrices and no turns of frames, which a renderer may have wrong.

namespace orbs::analytic {

namespace {

using Complex = std::complex<double>;
using Axes = std::array<double, 3>;
using Matrix = std::array<std::array<Complex, 3>, 3>;

Axes axes(Vec3d v) { return {v.x, v.y, v.z}; }

void add_outer(Matrix& matrix, Complex factor, Vec3d column, Vec3d row) {
  const Axes a = axes(column);
  const Axes b = axes(row);
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) matrix.at(i).at(j) += factor * a.at(i) * b.at(j);
}

// m light m*, with the conjugate transpose behind.
Matrix carried(const Matrix& m, const Matrix& light) {
  Matrix out{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t k = 0; k < 3; ++k)
        for (std::size_t l = 0; l < 3; ++l)
          out.at(i).at(j) += m.at(i).at(k) * light.at(k).at(l) * std::conj(m.at(j).at(l));
  return out;
}

// Half of the radiance in each direction across the ray.
Matrix unpolarised(double radiance, Vec3d along) {
  Matrix light{};
  for (std::size_t i = 0; i < 3; ++i) light.at(i).at(i) = radiance / 2;
  add_outer(light, -radiance / 2, along, along);
  return light;
}

Vec3d mirrored(Vec3d direction, Vec3d normal) { return direction - normal * (2 * dot(direction, normal)); }

// Of the field that arrives along `in` and leaves along `out`: s stays, and p is `along` cross s for both
// (Born and Wolf, figure 1.10).
Matrix reflection(const registry::PolarisedPlane& plane, Vec3d in, Vec3d out) {
  const auto across = cross(in, plane.normal);
  // Along the normal s and p come to the same, with any s across it.
  const auto s = length(across) > 1e-12
                     ? normalised(across)
                     : normalised(cross(in, std::fabs(in.x) < 0.5 ? Vec3d{1, 0, 0} : Vec3d{0, 1, 0}));
  const auto amplitude = fresnel_amplitudes(std::fabs(dot(in, plane.normal)), plane.n, plane.k);
  Matrix matrix{};
  add_outer(matrix, amplitude.s, s, s);
  add_outer(matrix, amplitude.p, cross(out, s), cross(in, s));
  return matrix;
}

// <(E . a) (E . b)*>
Complex correlation(const Matrix& light, Vec3d a, Vec3d b) {
  const Axes left = axes(a);
  const Axes right = axes(b);
  Complex sum = 0;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) sum += left.at(i) * light.at(i).at(j) * right.at(j);
  return sum;
}

}  // namespace

std::array<double, 4> polarised_planes(const registry::PolarisedPlanes& image, const Ray& ray, Vec3d right) {
  std::vector<Vec3d> directions{ray.direction};  // from the camera on; the light takes them back
  for (const auto& plane : image.planes) directions.push_back(mirrored(directions.back(), plane.normal));
  auto light = unpolarised(image.radiance, directions.back());
  for (std::size_t i = image.planes.size(); i-- > 0;)
    light = carried(reflection(image.planes[i], -directions[i + 1], -directions[i]), light);
  const auto along = -ray.direction;
  const auto x = normalised(right - along * dot(along, right));
  const auto y = cross(along, x);
  const double level = correlation(light, x, x).real();
  const double upright = correlation(light, y, y).real();
  // Fields vary as exp(-i w t): to who looks at the light, (1, -i) turns clockwise, hence right-circular.
  const auto mixed = correlation(light, x, y);
  return {level + upright, level - upright, 2 * mixed.real(), 2 * mixed.imag()};
}

}  // namespace orbs::analytic
