#pragma once

#include "scene/colour.h"

#include <array>
#include <string>

/// RGB without loss in pbrt, which always computes with wavelengths and would make a smooth spectrum of each
/// colour (Jakob and Hanika 2019): 0.5 to 2 % off after a few bounces, and negative pixels where noise is
/// left. Instead each colour is a spectrum of three steps, one step for each of R, G and B, and the film
/// averages the radiance over each step. Light of one step never reaches another, as in a renderer of three
/// colours.
namespace orbs::adapters::pbrt {

/// Film that averages over three bands of 100 nm; `size` holds its resolution.
std::string band_film(const std::string& size);

/// Channels of that film's image that hold R, G and B, as SpectralFilm::GetImage names them.
std::array<std::string, 3> band_channels();

/// `"spectrum name" [...]`: the colour as a spectrum of three steps.
std::string band_spectrum(const char* name, scene::RgbColour colour);

/// The emitted radiance of that colour: `"spectrum L" [...] "float scale" s`.
std::string band_radiance(scene::RgbColour radiance);

/// The spectrum texture `name`, the sum of three float images times their bands. `images` holds the names of
/// the float textures of R, G and B.
std::string band_texture(const std::string& name, const std::array<std::string, 3>& images);

}  // namespace orbs::adapters::pbrt
