#include "scene/effects/effect.h"

namespace orbs::scene {

std::string_view effect_name(Effect effect) {
  switch (effect) {
    case Effect::Spectral:
      return "spectral";
    case Effect::MeasuredMetal:
      return "measured metal";
    case Effect::Dispersion:
      return "dispersion";
    case Effect::ThinFilm:
      return "thin film";
    case Effect::Polarisation:
      return "polarisation";
    case Effect::Fluorescence:
      return "fluorescence";
    case Effect::RoughBoundary:
      return "rough boundary";
    case Effect::ReflectingLight:
      return "reflecting light";
    case Effect::AnalyticShape:
      return "analytic shape";
    case Effect::Texture:
      return "texture";
    case Effect::Ies:
      return "IES profile";
    case Effect::Instancing:
      return "instancing";
    case Effect::PathClasses:
      return "path classes";
    case Effect::Motion:
      return "motion";
    case Effect::LightWithoutArea:
      return "light without area";
    case Effect::Opacity:
      return "opacity";
    case Effect::TurnedNormals:
      return "turned normals";
    case Effect::EnvironmentMap:
      return "environment map";
    case Effect::SurfaceLayers:
      return "layers of the surface";
  }
  return "";
}

}  // namespace orbs::scene
