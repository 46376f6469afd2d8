#pragma once

#include "base/nth.h"
#include "spectra/rgb.h"
#include "spectra/wavelengths.h"
#include "tracer/bsdf/materials.h"
#include "tracer/transport/transport.h"

namespace orbs::tracer {

/// The wavelengths of a path: the hero wavelength, by which directions are sampled, and three secondary ones
/// (Wilkie et al. 2014, "Hero Wavelength Spectral Sampling").
struct HeroWavelengths {
  std::array<float, 4> nm{};               // at which the path looks for light now
  spectra::RgbBasis basis{};               // for upsampling colours at these wavelengths
  spectra::RgbMatching sensor_response{};  // at the wavelengths of the camera, divided by their pdf
  bool has_secondary = true;
};

/// A path carries spectral radiance (per nm) at four wavelengths.
struct SpectralTransport {
  using Value = Float4;
  using Throughput = Float4;
  using Contribution = Float4;
  using Lambda = HeroWavelengths;
  static constexpr std::size_t kWavelengths = 4;
  using Bsdf = AnyBsdf<Float4, kWavelengths>;
  static constexpr bool kHasAppearance = true;
  static constexpr bool kFluoresces = false;
  static constexpr bool kHasStokes = false;

  static Lambda sample_lambda(const auto& draw_number) {
    const auto sampled = spectra::sample_wavelengths(draw_number());
    Lambda out{sampled.nm, spectra::rgb_basis_at(sampled.nm), spectra::rgb_matching_at(sampled.nm)};
    for (std::size_t i = 0; i < 4; ++i) {
      const float share = 1 / (4 * sampled.pdf[i]);
      out.sensor_response.red[i] *= share;
      out.sensor_response.green[i] *= share;
      out.sensor_response.blue[i] *= share;
    }
    return out;
  }

  static std::array<float, 4> wavelengths_nm(const Lambda& lambda) { return lambda.nm; }
  static void set_wavelengths_nm(Lambda& lambda, const std::array<float, 4>& nm) {
    lambda.nm = nm;
    lambda.basis = spectra::rgb_basis_at(nm);
  }

  static Float4 spectrum_at(const World& world, int spectrum, const Lambda& lambda) {
    const auto& values = nth(world.spectra, spectrum);
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

  static Throughput start(const Camera&, const Ray&) { return Float4{1, 1, 1, 1}; }
  static Throughput chain(Throughput path, Value factor, const auto&) { return path * factor; }
  static Throughput scaled(Throughput path, float factor) { return path * factor; }
  static Contribution contribute(Throughput path, Value light) { return path * light; }
  static Contribution add(Contribution a, Contribution b) { return a + b; }
  static float magnitude(Throughput path) { return mean_of(path); }

  static Vec3f to_rgb(Contribution light, const Lambda& lambda) {
    const auto& response = lambda.sensor_response;
    Vec3f sum;
    for (std::size_t i = 0; i < 4; ++i)
      sum += Vec3f{response.red[i], response.green[i], response.blue[i]} * light[i];
    return sum;
  }

  /// Called where the directions of the wavelengths part: the hero wavelength continues alone and counts for
  /// all four, since each of them was equally likely to be the hero (pbrt-v4 does the same). Contributions
  /// found before keep their four wavelengths.
  static void terminate_secondary(Lambda& lambda, Throughput& path) {
    if (!lambda.has_secondary) return;
    lambda.has_secondary = false;
    lambda.nm.fill(lambda.nm[0]);
    lambda.basis.red.fill(lambda.basis.red[0]);
    lambda.basis.blue.fill(lambda.basis.blue[0]);
    lambda.basis.d65.fill(lambda.basis.d65[0]);
    path *= Float4{4, 0, 0, 0};
  }
};
static_assert(Transport<SpectralTransport>);

/// The same with fluorescence.
struct BispectralTransport : SpectralTransport {
  static constexpr bool kFluoresces = true;
};
static_assert(Transport<BispectralTransport>);

}  // namespace orbs::tracer
