#pragma once

#include "tracer/bsdf/bsdf.h"
#include "tracer/bsdf/conductor.h"
#include "tracer/bsdf/dielectric.h"
#include "tracer/bsdf/thin_element.h"

namespace orbs::tracer {

/// The surfaces of ORB.S and those whose reflectance follows from indices of refraction, for paths at N
/// wavelengths.
template <typename Value, std::size_t N>
using BoundaryBsdf = std::variant<LambertBsdf<Value>,
                                   OrenNayarBsdf<Value>,
                                   MirrorBsdf<Value>,
                                   GlassBsdf<Value>,
                                   GgxBsdf<Value>,
                                   RoughGlassBsdf<Value>,
                                   ConductorBsdf<Value, N>,
                                   RoughConductorBsdf<Value, N>,
                                   DielectricBsdf<Value, N>,
                                   RoughDielectricBsdf<Value, N>,
                                   ThinElementBsdf<Value, N>>;

}  // namespace orbs::tracer
