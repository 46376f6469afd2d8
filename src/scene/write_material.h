#pragma once

#include "json/writer.h"
#include "scene/scene.h"

namespace orbs::scene {

/// The members of a material but for its name and texture.
void write_model(json::Writer& out, const Scene& scene, const MaterialModel& model);

/// "spectra", when there are any: by their samples, wherever these came from.
void write_spectra(json::Writer& out, const Scene& scene);

/// [r, g, b], or the spectrum that stands in its place.
void write_colour(json::Writer& out,
                  const Scene& scene,
                  const char* key,
                  RgbColour rgb,
                  const std::optional<SpectrumUse>& spectrum);

}  // namespace orbs::scene
