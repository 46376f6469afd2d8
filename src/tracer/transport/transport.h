#pragma once

#include "base/vec.h"
#include "tracer/geometry/ray.h"
#include "tracer/world/world.h"

#include <array>
#include <concepts>

/// What a path carries. The path loop (trace_batch.h) is written once over the verbs below; an effect of light
/// is a struct that says what the verbs mean, so that a scene which does not call for it executes none of its
/// code.
namespace orbs::tracer {

template <typename T>
concept Transport = requires(const World& world,
                             typename T::Throughput weight,
                             typename T::Contribution light,
                             typename T::Value value,
                             typename T::Lambda lambda,
                             float u) {
  /// Scattering functions of the surfaces that such paths can meet: a std::variant.
  typename T::Bsdf;
  /// Layers that it fills beside the colour: S1 to S3.
  { T::kHasStokes } -> std::convertible_to<bool>;
  /// The wavelengths of a new path (nothing for colour). The argument draws a number in [0, 1).
  {
    T::sample_lambda([] { return 0.0F; })
    } -> std::same_as<typename T::Lambda>;
  /// A share of the light, and light, of the scene at these wavelengths.
  { T::reflectance(world, Colour{}, lambda) } -> std::same_as<typename T::Value>;
  { T::radiance(world, Radiance{}, lambda) } -> std::same_as<typename T::Value>;
  /// Weight of a path that has met nothing and begins along the ray.
  { T::start(world.camera, Ray{}) } -> std::same_as<typename T::Throughput>;
  /// (path so far, factor of the next scattering, where): the order matters where weights are matrices. The
  /// last argument, which makes a Scattering, is called where more than the factor counts.
  {
    T::chain(weight, value, [] { return 0; })
    } -> std::same_as<typename T::Throughput>;
  { T::scaled(weight, u) } -> std::same_as<typename T::Throughput>;
  /// What unpolarised light, seen through the path, adds to the pixel.
  { T::contribute(weight, value) } -> std::same_as<typename T::Contribution>;
  { T::add(light, light) } -> std::same_as<typename T::Contribution>;
  /// Steers Russian roulette.
  { T::magnitude(weight) } -> std::same_as<float>;
  /// The pixel's linear Rec.709 value.
  { T::to_rgb(light, lambda) } -> std::same_as<Vec3f>;
};

}  // namespace orbs::tracer
