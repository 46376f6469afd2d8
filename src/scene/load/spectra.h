#pragma once

#include "json/writer.h"
#include "scene/colour.h"
#include "scene/load/entry.h"
#include "spectra/refractive_index.h"
#include "spectra/table_file.h"

#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <vector>

/// Reading what a scene file says wavelength by wavelength. All functions throw InputError at the key that is
/// wrong.
/// Writing what load_spectra.h reads. Spectra are written by their samples, wherever these came from.

namespace orbs::scene {

/// The radiance that a channel of an image can hold.
constexpr json::Range kRadiance{0, std::numeric_limits<float>::max()};

/// The spectra of a scene file, and what reading it has found besides.
struct SpectralData {
  DataFolders folders;
  Names names = Names("spectrum");
  SpectrumList spectra = {};
  std::vector<std::filesystem::path> files = {};  // tables that have been read
  std::vector<std::string> warnings = {};
};

/// Adds one entry of "spectra": a constant, an illuminant by name, a column of a file, or samples.
void load_spectrum(json::ObjectReader in, SpectralData& data);
/// "wavelengths" and "values", with "beyond": "hold" or "zero".
spectra::Spectrum load_samples(json::ObjectReader& in);
/// The spectrum of the scene that "spectrum" names.
const spectra::Spectrum& find_spectrum(json::ObjectReader& in, const SpectralData& data);
/// The table that "file" names.
spectra::TableFile load_table(json::ObjectReader& in, SpectralData& data);

/// A colour as a scene file gives it: [r, g, b] or {"spectrum": name, "scale": number}.
struct Colour {
  RgbColour rgb;
  std::optional<SpectrumUse> spectrum;
};
/// Shares of light, in [0, 1] at every wavelength.
Colour load_reflectance(json::ObjectReader& in, const std::string& key, const SpectralData& data);
/// Radiance, not negative. A spectrum must be constant or zero beyond its samples.
Colour load_radiance(json::ObjectReader& in, const std::string& key, const SpectralData& data);

/// A number, or an object with "spectrum", "wavelengths", "sellmeier", "cauchy" or "file". Above 0
/// everywhere.
spectra::RefractiveIndex load_index(json::ObjectReader& in, const std::string& key, SpectralData& data);

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
