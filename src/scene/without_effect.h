#pragma once

#include "scene/effects.h"

namespace orbs::scene {

/// Makes the scene, in place, as a renderer without the effect would draw it:
///   Dispersion     every index is that of kUsualIndex_nm (materials/boundary.h)
///   MeasuredMetal  n and k are those of that wavelength
///   ThinFilm       no films
/// False, and nothing changes, for the other effects: they are left out by the transport, see WorldSettings
/// of the tracer. InputError naming the first material that calls for the effect and has no form without it.
bool leave_out(Effect effect, Scene& scene);

}  // namespace orbs::scene
