#pragma once

#include "base/vec.h"
#include "tracer/geometry/ray.h"
#include "tracer/world/world.h"

#include <array>
#include <concepts>

/// What a path carries. The path loop (integrator/trace_batch.h) is written once over the verbs below; an
/// effect of light is a struct that defines the verbs, so that a scene without the effect executes none of
/// its code.
namespace orbs::tracer {

template <typename T>
concept Transport = requires(const World& world,
                             typename T::Throughput throughput,
                             typename T::Contribution contribution,
                             typename T::Value value,
                             typename T::Lambda lambda,
                             float u) {
  /// BSDFs of the surfaces that such paths can hit: a std::variant.
  typename T::Bsdf;
  /// False if paths can only hit the materials of ORB.S.
  { T::kHasAppearance } -> std::convertible_to<bool>;
  /// The wavelength may change along the path (bsdf/fluorescent.h).
  { T::kFluoresces } -> std::convertible_to<bool>;
  /// The image has layers S1 to S3 beside its radiance.
  { T::kHasStokes } -> std::convertible_to<bool>;
  /// Number of wavelengths at which boundaries are evaluated, and these wavelengths.
  { T::wavelengths_nm(lambda) } -> std::same_as<std::array<float, T::kWavelengths>>;
  /// The wavelengths of a new path (empty for RGB). The argument draws a number in [0, 1).
  {
    T::sample_lambda([] { return 0.0F; })
    } -> std::same_as<typename T::Lambda>;
  /// Reduces the path to its hero wavelength before dispersion; does nothing to RGB.
  T::terminate_secondary(lambda, throughput);
  /// A reflectance and a radiance of the scene at the wavelengths of the path.
  { T::reflectance(world, Colour{}, lambda) } -> std::same_as<typename T::Value>;
  { T::radiance(world, Radiance{}, lambda) } -> std::same_as<typename T::Value>;
  /// Throughput of a path that starts along the ray.
  { T::start(world.camera, Ray{}) } -> std::same_as<typename T::Throughput>;
  /// (throughput so far, factor of the next scattering event, the event): the order matters where throughputs
  /// are matrices. The last argument makes a Scattering and is called only if more than the factor is needed.
  {
    T::chain(throughput, value, [] { return 0; })
    } -> std::same_as<typename T::Throughput>;
  { T::scaled(throughput, u) } -> std::same_as<typename T::Throughput>;
  /// What unpolarised light at the end of the path contributes to the pixel.
  { T::contribute(throughput, value) } -> std::same_as<typename T::Contribution>;
  { T::add(contribution, contribution) } -> std::same_as<typename T::Contribution>;
  /// Determines the survival probability of Russian roulette.
  { T::magnitude(throughput) } -> std::same_as<float>;
  /// The contribution in linear Rec.709.
  { T::to_rgb(contribution, lambda) } -> std::same_as<Vec3f>;
};

}  // namespace orbs::tracer
