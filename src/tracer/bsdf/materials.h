#pragma once

#include "tracer/bsdf/anisotropic_ggx.h"
#include "tracer/bsdf/blend.h"
#include "tracer/bsdf/conductor.h"
#include "tracer/bsdf/dielectric.h"
#include "tracer/bsdf/emission.h"
#include "tracer/bsdf/fluorescent.h"
#include "tracer/bsdf/ggx.h"
#include "tracer/bsdf/ggx_lambert.h"
#include "tracer/bsdf/glass.h"
#include "tracer/bsdf/lambert.h"
#include "tracer/bsdf/metal.h"
#include "tracer/bsdf/metallic_roughness.h"
#include "tracer/bsdf/mirror.h"
#include "tracer/bsdf/oren_nayar.h"
#include "tracer/bsdf/phong.h"
#include "tracer/bsdf/plastic.h"
#include "tracer/bsdf/rough_glass.h"
#include "tracer/bsdf/thin_element.h"
#include "tracer/bsdf/varying_ggx.h"

#include <type_traits>
#include <utility>
#include <variant>

/// All materials. A material is a file of this folder and a line in MaterialModel. A file that lacks one of
/// the following does not compile:
///   XMaterial                         its parameters, prepared once per scene
///     kIsAppearance                     false for the materials of ORB.S; true for all others, which
///                                       have path loops of their own
///     Bsdfs<Value, N>                   BsdfList of the BSDFs that its file defines
///   make_material(scene::X, colours)  prepares it
///   lobe_alpha(material)              roughness of its narrowest lobe: 0 for a delta function, or kNoLobe
///   make_bsdf(out, material, at)      makes its BSDF at a hit point (ShadingContext)
///   XBsdf<Value, N>                   the BSDF, textures looked up and the viewer's side known
///     kIsDelta, kDepolarises, kEvent    whether it is a delta function; whether it depolarises; its event
///   evaluate(bsdf, wo, wi)            f |cos wi| and pdf of wi, in the local frame with wo.z > 0
///   sample(bsdf, wo, u)               a BsdfSample; nothing if the sampled direction is below the surface
///   polarisation_by(bsdf, at)         its Mueller matrix, unless it depolarises
namespace orbs::tracer {

using MaterialModel = std::variant<LambertMaterial,
                                   OrenNayarMaterial,
                                   MirrorMaterial,
                                   GlassMaterial,
                                   GgxMaterial,
                                   RoughGlassMaterial,
                                   EmissionMaterial,
                                   ConductorMaterial,
                                   DielectricMaterial,
                                   ThinElementMaterial,
                                   FluorescentMaterial,
                                   MetalMaterial,
                                   MetallicRoughnessMaterial,
                                   PhongMaterial,
                                   PlasticMaterial,
                                   AnisotropicGgxMaterial,
                                   GgxLambertMaterial,
                                   VaryingGgxMaterial,
                                   BlendMaterial>;

template <typename... A, typename... B>
BsdfList<A..., B...> operator+(BsdfList<A...>, BsdfList<B...>);

template <typename... Bsdfs>
std::variant<Bsdfs...> variant_of(BsdfList<Bsdfs...>);

/// The BSDFs of one material; none if it is an appearance material and these are left out.
template <typename Material, typename Value, std::size_t N, bool kWithAppearance>
using BsdfsIfIncluded = std::conditional_t<(kWithAppearance || !Material::kIsAppearance),
                                           typename Material::template Bsdfs<Value, N>,
                                           BsdfList<>>;

/// The BSDFs of all materials, or of those of ORB.S alone.
template <typename Models, typename Value, std::size_t N, bool kWithAppearance>
struct BsdfsOf;

template <typename... Material, typename Value, std::size_t N, bool kWithAppearance>
struct BsdfsOf<std::variant<Material...>, Value, N, kWithAppearance> {
  using List = decltype((BsdfList<>{} + ... + BsdfsIfIncluded<Material, Value, N, kWithAppearance>{}));
  using Variant = decltype(variant_of(List{}));
};

/// BSDFs of the materials of ORB.S.
template <typename Value>
using OrbsBsdf = typename BsdfsOf<MaterialModel, Value, 1, false>::Variant;

/// BSDFs of all materials, for paths with N wavelengths.
template <typename Value, std::size_t N>
using AnyBsdf = typename BsdfsOf<MaterialModel, Value, N, true>::Variant;

/// A material of the scene as the path loop reads it.
struct SurfaceMaterial {
  MaterialModel model;
  bool is_delta = false;
  /// It is a delta function or has a lobe so narrow that light sampling at the surface hardly ever finds the
  /// light in it: light paths are worth sending towards it.
  bool is_near_specular = false;
};

template <typename... B>
bool is_delta(const std::variant<B...>& bsdf) {
  return std::visit([](const auto& b) { return b.kIsDelta; }, bsdf);
}

template <typename... B>
Event event_of(const std::variant<B...>& bsdf) {
  return std::visit([](const auto& b) { return b.kEvent; }, bsdf);
}

template <typename... B>
auto evaluate(const std::variant<B...>& bsdf, Vec3f wo, Vec3f wi) {
  return std::visit([&](const auto& b) { return evaluate(b, wo, wi); }, bsdf);
}

template <typename... B>
auto sample(const std::variant<B...>& bsdf, Vec3f wo, const std::array<float, 4>& u) {
  return std::visit([&](const auto& b) { return sample(b, wo, u); }, bsdf);
}

}  // namespace orbs::tracer
