#pragma once

#include "adapters/exporter.h"

#include <vector>

namespace orbs::adapters {

/// Radiosity is POV-Ray's name for indirect light: irradiance caching after Ward et al. 1988, which is
/// biased; the numbers set its quality. A Cornell box of 256 x 256 came to 38.2 dB with the defaults, and to
/// 38.6 with twice the rays.
struct PovrayRadiosity {
  /// Rays per cached point; half of it at each further bounce; at most 1600.
  int count = 200;
  /// Allowed error of interpolation: smaller puts cached points closer together.
  double error_bound = 0.3;
  /// Multiplies error_bound while the cache is being filled.
  double low_error_factor = 0.5;
  /// Cached points that a value is averaged from; at most 20.
  int nearest_count = 10;
  /// First and last spacing of the passes that fill the cache, as shares of the image's width.
  double pretrace_start = 0.04;
  double pretrace_end = 0.005;
  /// Bounds of a cached point's radius, as shares of its distance from the camera.
  double minimum_reuse = 0.005;
  double maximum_reuse = 0.2;
  /// Add cached points in the final pass too, which shows the borders of its blocks.
  bool always_sample = false;
};

struct PovraySettings {
  /// Light samples along each side of a rect; a power of two, since POV-Ray halves its grid until four
  /// samples are left and weighs unevenly where a half has an odd count.
  int area_grid = 16;
  /// A rect becomes split x split light sources at least (a power of two), more where it is large beside what
  /// it lights: radiosity takes each for a point at its centre, see also panels_per_side.
  int area_split = 2;
  /// Halvings of the grid that POV-Ray makes even where the corners agree; more finds thinner shadows and
  /// costs more.
  int area_adaptive = 0;
  PovrayRadiosity radiosity;
  /// In the place of povray_aa_grid, where it is above 0.
  int aa_depth = 0;
  /// Colours that a ray is split into by glass that disperses, and every photon with it.
  int dispersion_samples = 20;
  /// About so many photons to keep, aimed at mirrors and glass; 0: no caustics. Where glass disperses, and
  /// splits each, as many fewer are aimed. Noise and bias of the density that they estimate fall with their
  /// number: the light that a plane mirror throws on a ceiling came out 12 % too bright with 3 000 and 2 %
  /// with 200 000; scene 102 has 31.5 dB with 200 000 and 35.9 with 3 200 000, in 179 instead of 141 CPU
  /// seconds.
  int photons = 0;
};

/// The settings of configuration.json that povray_settings reads.
std::vector<SceneSetting> povray_setting_names();

/// The defaults with these numbers in their place; each name must be one of povray_setting_names.
PovraySettings povray_settings(const SceneSettings& numbers);

}  // namespace orbs::adapters
