#pragma once

#include "scene/effects.h"

namespace orbs::scene {

/// The wavelength at which indices are usually quoted: helium's d line.
constexpr double kUsualIndex_nm = 587.56;

/// The scene as someone would draw it who does not know the effect, in place:
///   Dispersion     every index is that of kUsualIndex_nm
///   MeasuredMetal  n and k are those of that wavelength
///   ThinFilm       no films
/// False, and nothing changes, for the other effects: the transport has them, see WorldSettings of the
/// tracer.
bool leave_out(Effect effect, Scene& scene);

}  // namespace orbs::scene
