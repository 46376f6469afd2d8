#pragma once

#include "scene/effects/effect.h"
#include "scene/scene.h"

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// Which effects of light a scene calls for, and why. The tracer simulates these and no others.

namespace orbs::scene {

/// An effect and the object of the scene that could call for it, with the reason why it does or does not.
struct EffectFinding {
  Effect effect = Effect::Spectral;
  std::string object;  // "material 'copper'"
  std::string reason;  // follows the object: "has n and k that differ from wavelength to wavelength"
};

/// Findings in the order of Effect, then of the scene.
struct SceneEffects {
  std::vector<EffectFinding> called_for;
  std::vector<EffectFinding> not_called_for;  // for example a spectrum that is constant
};

/// Exact about objects that look like an effect and are none: spectra that are constant, indices that vary by
/// less than kLeastDispersion, films without height, kernels that are zero, lights whose colour says
/// everything. Everything counts whether or not light can reach it: a polariser behind the camera calls for
/// polarisation, but materials that no surface shows call for nothing.
SceneEffects effects(const Scene& scene);

bool calls_for(const SceneEffects& found, Effect effect);

/// What a light path must carry.
enum class LightTransport { Rgb, Spectral, Polarised, Bispectral, PolarisedBispectral };

inline constexpr std::array kTransports{LightTransport::Rgb, LightTransport::Spectral,
                                        LightTransport::Polarised, LightTransport::Bispectral,
                                        LightTransport::PolarisedBispectral};

/// The word for it, as files and command lines write it: "rgb".
std::string_view transport_name(LightTransport transport);
/// Nothing for other words.
std::optional<LightTransport> transport_named(std::string_view name);

/// The cheapest one that has all effects. All but Rgb carry wavelengths.
LightTransport transport(const SceneEffects& found);
LightTransport transport(const Scene& scene);

/// True when `richer` has all that `needed` has.
bool covers(LightTransport richer, LightTransport needed);

/// Whether some surface scatters wavelengths differently, so that more than a light's colour counts.
bool has_coloured_surface(const Scene& scene);

/// " because material 'prism' has an index that varies by 0.0425": what the transport is for; "" for Rgb.
std::string reason_for(const SceneEffects& found);

/// The transport that an effect alone calls for.
LightTransport transport_for(Effect effect);

/// Makes the scene, in place, as a renderer without the effect would draw it:
///   Dispersion     every index is that of kUsualIndex_nm (materials/boundary.h)
///   MeasuredMetal  n and k are those of that wavelength
///   ThinFilm       no films
///   Motion         the scene at rest as it is when the shutter opens
///   EnvironmentMap the environment shines everywhere as it does where its image is white
///   Opacity        all is opaque
///   TurnedNormals  no normal maps and no bumps
///   SurfaceLayers  no layers
/// False, and nothing changes, for the other effects: they are left out by the transport, see WorldSettings
/// of the tracer. InputError naming the first material that calls for the effect and has no form without it.
bool leave_out(Effect effect, Scene& scene);

/// InputError where `verdicts`, those of a material of this name and type, still call for the effect.
void refuse_effect(Effect effect,
                   const std::vector<EffectVerdict>& verdicts,
                   const std::string& material,
                   const char* type);

/// The same for one material of the scene. Types that have a form without an effect overload
/// leave_out(effect, model) beside their struct. A type that does not must not call for the effect, because
/// its image would silently stay as it is.
template <MaterialType Model>
void leave_out_of(const SpectrumList& spectra, Effect effect, const std::string& material, Model& model) {
  if constexpr (requires { leave_out(effect, model); }) leave_out(effect, model);
  refuse_effect(effect, effects(spectra, model), material, Model::kType);
}

}  // namespace orbs::scene
