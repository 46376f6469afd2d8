#pragma once

#include "json/writer.h"
#include "scene/colour.h"
#include "spectra/refractive_index.h"

#include <optional>

/// Writing what load_spectra.h reads. Spectra are written by their samples, wherever these came from.
namespace orbs::scene {

/// "spectra", when there are any.
void write_spectra(json::Writer& out, const SpectrumList& spectra);

/// A colour as [r, g, b], or the spectrum that stands in its place.
void write_colour(json::Writer& out,
                  const SpectrumList& spectra,
                  const char* key,
                  RgbColour rgb,
                  const std::optional<SpectrumUse>& spectrum);

/// A number where the spectrum is constant, else an object with its samples.
void write_curve(json::Writer& out, const char* key, const spectra::Spectrum& spectrum);

/// A refractive index: a curve, or the coefficients of its formula.
void write_index(json::Writer& out, const char* key, const spectra::RefractiveIndex& index);

}  // namespace orbs::scene
