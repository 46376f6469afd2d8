#pragma once

#include "scene/scene.h"

#include <filesystem>
#include <string>
#include <vector>

namespace orbs::adapters {

/// POV-Ray's name for light that comes from other surfaces: irradiance caching after Ward et al. 1988.
/// Biased; the numbers are its quality. A Cornell box of 256 x 256 came
/// to 38.2 dB with the defaults, and to 38.6 with twice the rays.
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
  /// Lamp samples along each side of a rect; a power of two, since POV-Ray halves its grid until four samples
  /// are left and weighs unevenly where a half has an odd count.
  int area_grid = 16;
  /// A rect becomes split x split light sources at least (a power of two), more where it is large beside what
  /// it lights: radiosity takes each for a point at its centre, see also panels_per_side.
  int area_split = 2;
  /// Halvings of the grid that POV-Ray makes even where the corners agree; more finds thinner shadows and
  /// costs more.
  int area_adaptive = 0;
  PovrayRadiosity radiosity;
  /// Colours that a ray is split into by glass that disperses, and every photon with it.
  int dispersion_samples = 20;
  /// About so many photons to keep, aimed at mirrors and glass; 0: no caustics. Where glass disperses, and
  /// splits each, as many fewer are aimed. Noise and bias of the density that they estimate fall with their
  /// number: the light that a plane mirror throws on a ceiling came out 12 % too bright with 3 000 and 2 %
  /// with 200 000; scene 102 has 31.5 dB with 200 000 and 35.9 with 3 200 000, in 179 instead of 141 CPU
  /// seconds.
  int photons = 0;
};

/// n of `+AM2 +Rn`: pixels whose corners differ are halved up to n times, which gives an edge 4^n places, as
/// spp random samples do: the least n with 4^n >= spp, within [3, 9]. POV-Ray takes 1 and 2 as well, but it
/// weighs the corners by the trapezoid rule, which adds 4^-n / 6 to the variance of a pixel's box filter:
/// edges of scene 305 were 0.22 pixels softer with n = 2 (37.3 dB, 38.9 with 3). Its other method, an n x n
/// grid with +AM1, misses the sliver of a bright lamp that an edge leaves in a row of pixels: direct light of
/// a Cornell box came to 35.4 dB with n = 3 and to 40.0 with +AM2 +R4 in a fifth of the time.
int povray_aa_grid(int spp);

/// What of the scene POV-Ray 3.7 cannot do, one reason each; empty when it can do all of it. What it merely
/// does slowly or with noise is not listed. Reads only the scene, no file.
std::vector<std::string> povray_limits(const scene::Scene& scene, const PovraySettings& settings = {});

/// Writes the scene in POV-Ray's language to `file`, its meshes to `<stem>-meshes.inc` and copies of its
/// textures to
/// `<stem>-texture<i>.<extension>`, all in the folder of `file`: POV-Ray's I/O restrictions let it read the
/// folder that it is started in. Lower the scene first; povray_limits must be empty. InputError when a file
/// cannot be read or written or when the lamp grid is none that POV-Ray weighs evenly.
void write_povray(const scene::Scene& scene,
                  const PovraySettings& settings,
                  const std::filesystem::path& file);

}  // namespace orbs::adapters
