#pragma once

#include <string>
#include <string_view>

namespace orbs::scene {

/// An effect of light that a scene may call for.
enum class Effect {
  Spectral,         // a spectrum that no colour can stand for
  MeasuredMetal,    // n and k differ from wavelength to wavelength
  Dispersion,       // light of different wavelengths is refracted differently
  ThinFilm,         // interference colours
  Polarisation,     // polarisers, retarders, Stokes vectors
  Fluorescence,     // light that changes its wavelength
  RoughBoundary,    // microfacets
  ReflectingLight,  // a light that also reflects
  AnalyticShape,    // a surface by its formula
  Texture,
  Ies,
  Instancing,        // one mesh in several places
  PathClasses,       // a layer for each class of light path
  Motion,            // something moves while the shutter is open
  LightWithoutArea,  // a point, a spot, a direction
  Opacity,           // surfaces that let a share of the rays pass
  TurnedNormals,     // normals by a texture
  EnvironmentMap,    // an image that shines from infinitely far away
  SurfaceLayers,     // layers of the surface that the camera sees
};

/// The word for it, as messages and files write it: "thin film".
std::string_view effect_name(Effect effect);

/// Whether one object of a scene calls for an effect.
struct EffectVerdict {
  Effect effect = Effect::Spectral;
  bool is_called_for = false;
  std::string reason;  // continues a sentence whose subject is the object: "has a texture"
};

}  // namespace orbs::scene
