#pragma once

#include "base/vec.h"

#include <concepts>

/// What a path carries. The path loop (trace_wave.h) is written once over the verbs below; an effect of light
/// is a struct that says what the verbs mean, so that a scene which does not call for it executes none of its
/// code.
namespace orbs::tracer {

template <typename T>
concept Transport = requires(typename T::Weight weight,
                             typename T::Light light,
                             typename T::Value value,
                             typename T::Lambda lambda,
                             Vec3f rgb,
                             float u) {
  /// The wavelengths of a new path (nothing for colour).
  { T::sample_lambda(u) } -> std::same_as<typename T::Lambda>;
  /// A colour of the scene at these wavelengths.
  { T::from_rgb(rgb, lambda) } -> std::same_as<typename T::Value>;
  /// Weight of a path that has met nothing.
  { T::one() } -> std::same_as<typename T::Weight>;
  /// (path so far, next bounce): the order matters where weights are matrices.
  { T::chain(weight, weight) } -> std::same_as<typename T::Weight>;
  { T::scaled(weight, u) } -> std::same_as<typename T::Weight>;
  /// What light, seen through the path, adds to the pixel.
  { T::contribute(weight, light) } -> std::same_as<typename T::Light>;
  { T::add(light, light) } -> std::same_as<typename T::Light>;
  /// Light without any preferred orientation.
  { T::unpolarised(value) } -> std::same_as<typename T::Light>;
  /// Weight of a surface that forgets orientation (Lambert and its like).
  { T::depolarising(value) } -> std::same_as<typename T::Weight>;
  /// Steers Russian roulette.
  { T::magnitude(weight) } -> std::same_as<float>;
  /// (wavelengths now, wavelengths that the surface proposes): only fluorescence takes the second.
  { T::next_lambda(lambda, lambda) } -> std::same_as<typename T::Lambda>;
  /// The pixel's linear Rec.709 value.
  { T::to_rgb(light, lambda) } -> std::same_as<Vec3f>;
};

struct NoWavelengths {};

/// Three channels of linear Rec.709 and nothing else.
struct RgbTransport {
  using Value = Vec3f;
  using Weight = Vec3f;
  using Light = Vec3f;
  using Lambda = NoWavelengths;
  static Lambda sample_lambda(float) { return {}; }
  static Value from_rgb(Vec3f rgb, Lambda) { return rgb; }
  static Weight one() { return {1, 1, 1}; }
  static Weight chain(Weight path, Weight bounce) { return path * bounce; }
  static Weight scaled(Weight weight, float factor) { return weight * factor; }
  static Light contribute(Weight path, Light light) { return path * light; }
  static Light add(Light a, Light b) { return a + b; }
  static Light unpolarised(Value value) { return value; }
  static Weight depolarising(Value value) { return value; }
  static float magnitude(Weight weight) { return largest(weight); }
  static Lambda next_lambda(Lambda current, Lambda) { return current; }
  static Vec3f to_rgb(Light light, Lambda) { return light; }
};
static_assert(Transport<RgbTransport>);

}  // namespace orbs::tracer
