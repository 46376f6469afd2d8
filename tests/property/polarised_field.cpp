#include "property/polarised_field.h"

#include <cmath>

namespace orbs::tests {

namespace {

Complex dot(const Field& field, Vec3d v) { return field.e[0] * v.x + field.e[1] * v.y + field.e[2] * v.z; }

Field along(Vec3d v, Complex amplitude) { return {{amplitude * v.x, amplitude * v.y, amplitude * v.z}}; }

Field sum(const Field& a, const Field& b) { return {{a.e[0] + b.e[0], a.e[1] + b.e[1], a.e[2] + b.e[2]}}; }

Vec3d across(Vec3d direction) {
  return normalised(cross(direction, std::abs(direction.x) < 0.9 ? Vec3d{1, 0, 0} : Vec3d{0, 1, 0}));
}

// Multiplies the field across the plane of incidence and that within it by amplitudes, the latter measured
// along direction x across before and after.
Beam reflected(const Beam& beam, Vec3d normal, Complex r_s, Complex r_p) {
  const Vec3d d = beam.direction;
  const Vec3d sideways = cross(d, normal);
  const Vec3d s = length(sideways) > 1e-9 ? normalised(sideways) : across(d);
  const Vec3d out = d - normal * (2 * orbs::dot(d, normal));
  Beam result{out, {}};
  for (std::size_t i = 0; i < 2; ++i)
    result.fields[i] = sum(along(s, r_s * dot(beam.fields[i], s)),
                           along(cross(out, s), r_p * dot(beam.fields[i], cross(d, s))));
  return result;
}

}  // namespace

Beam unpolarised(Vec3d direction) {
  const Vec3d d = normalised(direction);
  const Vec3d a = across(d);
  const Complex half = std::sqrt(0.5);
  return {d, {along(a, half), along(cross(d, a), half)}};
}

// Born and Wolf, 7th edition, 1.5.2, eq. 21a.
Beam reflected(const Beam& beam, Vec3d normal, Complex index) {
  const double cos_i = std::abs(orbs::dot(beam.direction, normal));
  // The root with a positive imaginary part decays with depth.
  Complex beyond = std::sqrt(index * index - (1 - cos_i * cos_i));
  if (beyond.imag() < 0) beyond = -beyond;
  return reflected(beam, normal, (cos_i - beyond) / (cos_i + beyond),
                   (index * index * cos_i - beyond) / (index * index * cos_i + beyond));
}

Beam mirrored(const Beam& beam, Vec3d normal) { return reflected(beam, normal, -1, 1); }

Beam polarised_along(const Beam& beam, Vec3d axis) {
  const Vec3d x = normalised(axis - beam.direction * orbs::dot(axis, beam.direction));
  return {beam.direction, {along(x, dot(beam.fields[0], x)), along(x, dot(beam.fields[1], x))}};
}

Beam dimmed(const Beam& beam, double amplitude) {
  Beam result = beam;
  for (Field& field : result.fields)
    for (Complex& e : field.e) e *= amplitude;
  return result;
}

std::array<double, 4> stokes_of(const Beam& beam, Vec3d right) {
  const Vec3d x = normalised(right - beam.direction * orbs::dot(right, beam.direction));
  const Vec3d y = cross(beam.direction, x);
  std::array<double, 4> s{};
  for (const Field& field : beam.fields) {
    const Complex ex = dot(field, x);
    const Complex ey = dot(field, y);
    s[0] += std::norm(ex) + std::norm(ey);
    s[1] += std::norm(ex) - std::norm(ey);
    s[2] += 2 * (ex * std::conj(ey)).real();
    s[3] += 2 * (ex * std::conj(ey)).imag();
  }
  return s;
}

}  // namespace orbs::tests
