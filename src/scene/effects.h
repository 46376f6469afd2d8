#pragma once

#include "scene/scene.h"

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// Which effects of light a scene calls for, and why. What a scene does not call for, nobody need simulate.
namespace orbs::scene {

enum class Effect {
  Spectral,         // a spectrum that no colour can stand for
  MeasuredMetal,    // n and k differ from wavelength to wavelength
  Dispersion,       // light of different wavelengths is refracted differently
  ThinFilm,         // interference colours
  Polarisation,     // polarisers, retarders, Stokes vectors
  Fluorescence,     // light that changes its wavelength
  RoughInterface,   // microfacets
  ReflectingLight,  // a light that also reflects
  AnalyticShape,    // a surface by its formula
  Texture,
  Ies,
  Instancing,   // one mesh in several places
  PathClasses,  // a layer for each class of light path
};

/// The word for it, as messages and files write it: "thin film".
std::string_view effect_name(Effect effect);

/// An effect and the thing in the scene that would call for it, with the reason why it does or does not.
struct EffectFinding {
  Effect effect = Effect::Spectral;
  std::string thing;   // "material 'copper'"
  std::string reason;  // follows the thing: "has n and k that differ from wavelength to wavelength"
};

/// Findings in the order of Effect, then of the scene.
struct SceneEffects {
  std::vector<EffectFinding> called_for;
  std::vector<EffectFinding> not_called_for;  // looks as if it called for the effect, but does not
};

/// Exact about what looks like an effect and is none: spectra that are constant, indices that vary by less
/// than kLeastDispersion, films without height, kernels that are zero, lights whose colour says everything.
/// What is there counts whether or not light can reach it: a polariser behind the camera calls for
/// polarisation, but materials that no surface shows call for nothing.
SceneEffects effects(const Scene& scene);

bool calls_for(const SceneEffects& found, Effect effect);

/// An index that varies by less refracts 1e-6 radians differently, a thousandth of a pixel of an image of
/// 1000 pixels.
constexpr double kLeastDispersion = 1e-6;

/// Whether the interface refracts light of different wavelengths differently by more than that.
bool is_dispersive(const Dielectric& glass);

/// What a light path must carry.
enum class LightTransport { Rgb, Spectral, Polarised, Bispectral, PolarisedBispectral };

inline constexpr std::array kTransports{LightTransport::Rgb, LightTransport::Spectral,
                                        LightTransport::Polarised, LightTransport::Bispectral,
                                        LightTransport::PolarisedBispectral};

/// The word for it; "rgb" for Colour.
std::string_view transport_name(LightTransport transport);
/// Nothing for other words.
std::optional<LightTransport> transport_named(std::string_view name);

/// The cheapest one that has all effects. All but Colour carry wavelengths.
LightTransport transport(const SceneEffects& found);
LightTransport transport(const Scene& scene);

/// True when `richer` has all that `needed` has.
bool covers(LightTransport richer, LightTransport needed);

/// " because material 'prism' has an index that varies by 0.0425": what the transport is for; "" for Colour.
std::string reason_for(const SceneEffects& found);

/// The transport that an effect alone calls for.
LightTransport transport_for(Effect effect);

}  // namespace orbs::scene
