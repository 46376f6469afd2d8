#pragma once

#include "tracer/bsdf/polarisation.h"
#include "tracer/transport/spectral_transport.h"

#include <algorithm>

namespace orbs::tracer {

/// Rows of the product of the Mueller matrices along the path, one for each Stokes parameter that the camera
/// records: they map the Stokes vector of the light at the end of the path to the recorded parameters. Each
/// entry holds four wavelengths.
template <std::size_t kRows>
struct StokesRows {
  std::array<std::array<Float4, 4>, kRows> row{};
  Vec3f x;  // reference direction of the arriving light, across the ray
  /// After a depolarising surface only row[.][0] counts, until the path hits a surface that polarises.
  bool is_scalar = true;
};

/// Adds polarisation to the spectral transport `S`; conventions as in data/snippets/fresnel_mueller.h. With
/// one row the camera records S0, with four rows S0 to S3.
template <typename S, std::size_t kRows>
struct PolarisedTransport : S {
  using Value = typename S::Value;
  using Lambda = typename S::Lambda;
  using Throughput = StokesRows<kRows>;
  using Contribution = std::array<Float4, kRows>;
  static constexpr bool kHasStokes = kRows == 4;

  /// The camera's reference frame: x points to the right of the image, seen by a viewer who faces the source.
  static Throughput start(const Camera& camera, const Ray& ray) {
    Throughput out;
    for (std::size_t k = 0; k < kRows; ++k) out.row[k][k] = Float4{1, 1, 1, 1};
    const Vec3f right = image_right(camera, ray);
    out.x = normalised(right - ray.direction * dot(ray.direction, right));
    out.is_scalar = kRows == 1;
    return out;
  }

  template <typename F>
  static Throughput chain(const Throughput& path, Value factor, const F& make_scattering) {
    const auto scattering = make_scattering();
    const auto polarisation = polarisation_of(scattering);
    return polarisation ? polarised(path, factor, *polarisation, scattering.to_viewer)
                        : depolarised(path, factor);
  }

  static Throughput scaled(Throughput path, float factor) {
    for (auto& row : path.row)
      for (auto& entry : row) entry *= factor;
    return path;
  }
  static Contribution contribute(const Throughput& path, Value light) {
    Contribution out;
    for (std::size_t k = 0; k < kRows; ++k) out[k] = path.row[k][0] * light;
    return out;
  }
  static Contribution add(Contribution a, const Contribution& b) {
    for (std::size_t k = 0; k < kRows; ++k) a[k] += b[k];
    return a;
  }
  /// The first row bounds the others, as the degree of polarisation is at most 1. The maximum is for rounding
  /// only: behind crossed polarisers an exact zero may come out negative.
  static float magnitude(const Throughput& path) { return std::max(0.0F, S::magnitude(path.row[0][0])); }
  static Vec3f to_rgb(const Contribution& light, const Lambda& lambda) { return S::to_rgb(light[0], lambda); }
  /// Stokes parameter k in linear Rec.709.
  static Vec3f stokes(const Contribution& light, std::size_t k, const Lambda& lambda) {
    return S::to_rgb(light[k], lambda);
  }
  static void terminate_secondary(Lambda& lambda, Throughput& path) {
    Float4 shares{1, 1, 1, 1};
    S::terminate_secondary(lambda, shares);
    for (auto& row : path.row)
      for (auto& entry : row) entry *= shares;
  }

 private:
  static Throughput depolarised(const Throughput& path, Value factor) {
    Throughput out;
    for (std::size_t k = 0; k < kRows; ++k) out.row[k][0] = path.row[k][0] * factor;
    return out;
  }

  static Throughput polarised(const Throughput& path,
                              Value factor,
                              const Polarisation& surface,
                              Vec3f to_viewer) {
    Throughput out;
    out.x = surface.x_arriving;
    out.is_scalar = false;
    const auto rotation = snippets::frame_turn_between(surface.x_leaving, path.x, to_viewer);
    for (std::size_t k = 0; k < kRows; ++k) {
      const auto& row = path.row[k];
      const auto& e = surface.element;
      const Float4 r0 = row[0] * factor;
      if (path.is_scalar) {
        out.row[k] = {r0, r0 * e.half, Float4{}, Float4{}};
        continue;
      }
      const Float4 r1 = (row[1] * rotation.cos2 - row[2] * rotation.sin2) * factor;
      const Float4 r2 = (row[2] * rotation.cos2 + row[1] * rotation.sin2) * factor;
      const Float4 r3 = row[3] * factor;
      out.row[k] = {r0 + r1 * e.half, r0 * e.half + r1, r2 * e.real + r3 * e.imaginary,
                    r3 * e.real - r2 * e.imaginary};
    }
    return out;
  }
};
static_assert(Transport<PolarisedTransport<SpectralTransport, 1>>);

}  // namespace orbs::tracer
