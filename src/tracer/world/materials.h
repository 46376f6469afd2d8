#pragma once

#include "scene/scene.h"
#include "tracer/world/world.h"

#include <optional>

namespace orbs::tracer {

/// Fills world.materials and the tables that they point into. The world knows its transport.
void add_materials(const scene::Scene& scene, World& world);

/// Index in world.spectra of the spectrum that is used, or -1 when there is none or paths carry colour.
int add_spectrum(const scene::Scene& scene, const std::optional<scene::SpectrumUse>& use, World& world);

/// True for surfaces that scatter light into single directions.
bool is_smooth(const SurfaceMaterial& material);

}  // namespace orbs::tracer
