#pragma once

#include "tracer/scatter/bsdf.h"
#include "tracer/scatter/conductor.h"
#include "tracer/scatter/dielectric.h"
#include "tracer/scatter/sheet.h"

namespace orbs::tracer {

/// The surfaces of ORB.S and those whose reflectance follows from indices of refraction, for paths at N
/// wavelengths.
template <typename Value, std::size_t N>
using InterfaceBsdf = std::variant<LambertBsdf<Value>,
                                   OrenNayarBsdf<Value>,
                                   MirrorBsdf<Value>,
                                   GlassBsdf<Value>,
                                   GgxBsdf<Value>,
                                   RoughGlassBsdf<Value>,
                                   ConductorBsdf<Value, N>,
                                   RoughConductorBsdf<Value, N>,
                                   DielectricBsdf<Value, N>,
                                   RoughDielectricBsdf<Value, N>,
                                   SheetBsdf<Value, N>>;

}  // namespace orbs::tracer
