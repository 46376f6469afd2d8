#pragma once

#include "base/in_double.h"
#include "snippets/ggx.h"
#include "tracer/bsdf/bsdf_sample.h"
#include "tracer/colour/scene_colours.h"
#include "tracer/geometry/transforms.h"
#include "tracer/sampling/warps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

namespace orbs::tracer {

/// Glossy reflection without a Fresnel factor of microfacets with a roughness along `axis` and one across it,
/// a unit vector in the x-y plane of the local frame. Light is depolarised.
template <typename Value>
struct AnisotropicGgxBsdf {
  static constexpr bool kIsDelta = false;
  static constexpr bool kDepolarises = true;
  static constexpr Event kEvent = Event::Glossy;
  Value colour{};
  Vec2f alpha{};
  Vec2f axis{1, 0};
  bool is_correlated = true;
};

/// In the frame whose x axis is `axis`; from there back with the axis mirrored in x.
inline Vec3f along_axis(Vec2f axis, Vec3f w) {
  return {axis.x * w.x + axis.y * w.y, axis.x * w.y - axis.y * w.x, w.z};
}

template <typename Value>
BsdfValue<Value> evaluate(const AnisotropicGgxBsdf<Value>& bsdf, Vec3f wo, Vec3f wi) {
  if (wi.z <= 0) return {};
  const Vec3f o = along_axis(bsdf.axis, wo);
  const Vec3f i = along_axis(bsdf.axis, wi);
  const float lambda_o = snippets::ggx_lambda(o, bsdf.alpha.x, bsdf.alpha.y);
  const float lambda_i = snippets::ggx_lambda(i, bsdf.alpha.x, bsdf.alpha.y);
  const float g2 = bsdf.is_correlated ? snippets::smith_g2_correlated(lambda_o, lambda_i)
                                      : snippets::smith_g2_separable(lambda_o, lambda_i);
  const float d = snippets::ggx_d(normalised(o + i), bsdf.alpha.x, bsdf.alpha.y) / (4 * wo.z);
  return {bsdf.colour * (d * g2), snippets::smith_g1(lambda_o) * d};
}

template <typename Value>
std::optional<BsdfSample<Value>> sample(const AnisotropicGgxBsdf<Value>& bsdf,
                                        Vec3f wo,
                                        const std::array<float, 4>& u) {
  const Vec3f o = along_axis(bsdf.axis, wo);
  const Vec3f m = snippets::sample_ggx_visible(o, bsdf.alpha.x, bsdf.alpha.y, sample_disk(u[0], u[1]));
  const Vec3f wi = along_axis({bsdf.axis.x, -bsdf.axis.y}, m * (2 * dot(o, m)) - o);
  const auto value = evaluate(bsdf, wo, wi);
  if (!(value.pdf > 0)) return std::nullopt;
  return BsdfSample<Value>{.wi = wi, .weight = value.f_cos * (1 / value.pdf), .pdf = value.pdf};
}

struct AnisotropicGgxMaterial {
  static constexpr bool kIsAppearance = true;
  template <typename Value, std::size_t N>
  using Bsdfs = BsdfList<AnisotropicGgxBsdf<Value>>;
  Colour colour;
  Vec2f alpha{};
  float rotation = 0;  // radians
  bool is_correlated = true;
};

inline AnisotropicGgxMaterial make_material(const scene::AnisotropicGgx& m, const SceneColours& colours) {
  return {make_colour(colours, m.colour, m.spectrum),
          {static_cast<float>(m.alpha_x), static_cast<float>(m.alpha_y)},
          static_cast<float>(m.rotation_deg * std::numbers::pi / 180),
          m.masking == scene::Masking::Correlated};
}

inline float lobe_alpha(const AnisotropicGgxMaterial& material) {
  return std::min(material.alpha.x, material.alpha.y);
}

/// The direction of increasing u at the surface, turned about the normal of the outside, in the x-y plane of
/// the frame in which the path scatters. Along the normal itself there is none: the frame's x stands in.
inline Vec2f axis_in_frame(Vec3f along_u, Vec3f outside, float rotation, bool is_outside) {
  const Vec3f turned =
      along_u * in_double::cos(rotation) + cross(outside, along_u) * in_double::sin(rotation);
  const Frame frame = frame_around(is_outside ? outside : -outside);
  const float x = dot(turned, frame.x);
  const float y = dot(turned, frame.y);
  const float length = std::sqrt(x * x + y * y);
  return length > 0 ? Vec2f{x / length, y / length} : Vec2f{1, 0};
}

template <typename Context>
void make_bsdf(typename Context::Bsdf& out, const AnisotropicGgxMaterial& material, const Context& at) {
  const Vec3f outside = at.surface.point.shading_normal;
  const Vec3f along_u = at.direction_of_u();
  const Vec3f across = along_u - outside * dot(outside, along_u);
  out = AnisotropicGgxBsdf<typename Context::Value>{
      at.reflectance(material.colour), material.alpha,
      axis_in_frame(across, outside, material.rotation, at.is_outside), material.is_correlated};
}

}  // namespace orbs::tracer
