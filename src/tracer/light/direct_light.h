#pragma once

#include "tracer/sampling/warps.h"

namespace orbs::tracer {

/// How light that arrives straight from an emitter is found: by light sampling (next-event estimation) and
/// BSDF sampling, weighted by the power heuristic (Veach 1997, ch. 9); by light sampling alone, but where it
/// cannot find the light (delta functions, the environment, emissive spheres); or by BSDF sampling alone. The
/// expected image is the same, but for Unweighted, a fault: both count in full.
enum class DirectLight { Mis, Light, Bsdf, Unweighted };

/// How light sampling selects one of several emitters: in proportion to its power alone, or by what it may
/// contribute to the point (light_bvh.h). The expected image is the same.
enum class LightSelection { Power, Bvh };

/// Weight of a light sample with this pdf, which BSDF sampling would find with bsdf_pdf and a connection to a
/// light vertex with connection_pdf (integrator/light_vertex.h; 0 if there are none).
template <typename Real>
Real light_weight(DirectLight direct_light, Real pdf, Real bsdf_pdf, Real connection_pdf) {
  return direct_light == DirectLight::Mis ? mis_weight(pdf, bsdf_pdf, connection_pdf) : Real{} + 1.0F;
}

/// Weight of an emitter that BSDF sampling found with this pdf; light_pdf is zero if light sampling cannot
/// find it.
inline float bsdf_weight(DirectLight direct_light, float pdf, float light_pdf, float connection_pdf) {
  switch (direct_light) {
    case DirectLight::Mis:
      break;
    case DirectLight::Light:
      return light_pdf > 0 ? 0 : 1;
    case DirectLight::Bsdf:
    case DirectLight::Unweighted:
      return 1;
  }
  return mis_weight(pdf, light_pdf, connection_pdf);
}

}  // namespace orbs::tracer
