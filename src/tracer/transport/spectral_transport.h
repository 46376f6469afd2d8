#pragma once

#include "spectra/rgb.h"
#include "spectra/wavelengths.h"
#include "tracer/bsdf/boundary_bsdf.h"
#include "tracer/transport/transport.h"

namespace orbs::tracer {

/// The wavelengths of a path: the hero, which chooses where the path goes, and three companions (Wilkie et
/// al. 2014, "Hero Wavelength Spectral Sampling").
struct HeroWavelengths {
  std::array<float, 4> nm{};   // at which the path looks for light now
  spectra::RgbBasis basis{};   // of colours, at these
  spectra::RgbMatching sensor_response{};  // what a contribution adds to R, G and B, by the wavelengths it arrives with
  bool has_secondary = true;
};

/// A path carries the radiance per nm at four wavelengths.
struct SpectralTransport {
  using Value = Float4;
  using Throughput = Float4;
  using Contribution = Float4;
  using Lambda = HeroWavelengths;
  static constexpr std::size_t kWavelengths = 4;
  using Bsdf = BoundaryBsdf<Float4, kWavelengths>;
  static constexpr bool kHasStokes = false;
  static constexpr bool kFluoresces = false;

  static Lambda sample_lambda(const auto& draw_number) {
    const auto chosen = spectra::sample_wavelengths(draw_number());
    Lambda out{chosen.nm, spectra::rgb_basis_at(chosen.nm), spectra::rgb_matching_at(chosen.nm)};
    for (std::size_t i = 0; i < 4; ++i) {
      const float share = 1 / (4 * chosen.pdf[i]);
      out.sensor_response.red[i] *= share;
      out.sensor_response.green[i] *= share;
      out.sensor_response.blue[i] *= share;
    }
    return out;
  }

  static Float4 spectrum_at(const World& world, int spectrum, const Lambda& lambda) {
    const auto& values = world.spectra[static_cast<std::size_t>(spectrum)];
    Float4 out{};
    for (std::size_t i = 0; i < 4; ++i)
      out[i] = static_cast<float>(spectra::value_at(values, static_cast<double>(lambda.nm[i])));
    return out;
  }

  static Value reflectance(const World& world, const Colour& colour, const Lambda& lambda) {
    return colour.spectrum < 0 ? float4(spectra::reflectances(colour.rgb, lambda.basis))
                               : spectrum_at(world, colour.spectrum, lambda);
  }
  static Value radiance(const World& world, const Radiance& radiance, const Lambda& lambda) {
    return radiance.spectrum < 0 ? float4(spectra::lights(radiance.rgb, lambda.basis))
                                 : spectrum_at(world, radiance.spectrum, lambda) * radiance.share;
  }

  static Throughput start(const PinholeCamera&, const Ray&) { return Float4{1, 1, 1, 1}; }
  static Throughput chain(Throughput path, Value factor, const auto&) { return path * factor; }
  static Throughput scaled(Throughput weight, float factor) { return weight * factor; }
  static Contribution contribute(Throughput path, Value light) { return path * light; }
  static Contribution add(Contribution a, Contribution b) { return a + b; }
  static float mean_of(Float4 v) { return (v[0] + v[1] + v[2] + v[3]) / 4; }
  static float magnitude(Throughput weight) { return mean_of(weight); }

  static Vec3f to_rgb(Contribution light, const Lambda& lambda) {
    Vec3f sum;
    for (std::size_t i = 0; i < 4; ++i)
      sum += Vec3f{lambda.sensor_response.red[i], lambda.sensor_response.green[i], lambda.sensor_response.blue[i]} * light[i];
    return sum;
  }

  /// Before light of different wavelengths goes different ways: the hero goes on alone and counts for all
  /// four, since each of them was as likely to be the hero. What the path has found before keeps its four.
  static void terminate_secondary(Lambda& lambda, Throughput& weight) {
    if (!lambda.has_secondary) return;
    lambda.has_secondary = false;
    lambda.nm.fill(lambda.nm[0]);
    lambda.basis.red.fill(lambda.basis.red[0]);
    lambda.basis.blue.fill(lambda.basis.blue[0]);
    lambda.basis.d65.fill(lambda.basis.d65[0]);
    weight *= Float4{4, 0, 0, 0};
  }
};
static_assert(Transport<SpectralTransport>);

/// The same where light may change its wavelength on the way (reradiation.h).
struct BispectralTransport : SpectralTransport {
  static constexpr bool kFluoresces = true;
};
static_assert(Transport<BispectralTransport>);

}  // namespace orbs::tracer
