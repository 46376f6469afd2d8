#pragma once

#include "scene/scene.h"

#include <filesystem>
#include <string>
#include <vector>

namespace orbs::adapters {

/// POV-Ray's name for light that comes from other surfaces: irradiance caching after Ward et al. 1988.
/// Biased; the numbers are its quality. The defaults are the cheapest that pass 35 dB on a Cornell box of 512
/// x 512.
struct PovrayRadiosity {
  int count = 1600;           // rays per cached point; half of it at each further bounce; at most 1600
  double error_bound = 0.25;  // allowed error of interpolation: smaller puts cached points closer together
  double low_error_factor = 0.5;  // multiplies error_bound while the cache is being filled
  int nearest_count = 10;         // cached points that a value is averaged from; at most 20
  double pretrace_start =
      0.04;  // first and last spacing of the passes that fill the cache, as a share of the picture
  double pretrace_end = 0.005;
  double minimum_reuse =
      0.005;  // bounds of a cached point's radius, as a share of its distance from the camera
  double maximum_reuse = 0.2;
  bool always_sample = false;  // add cached points in the final pass too (shows the borders of its blocks)
};

struct PovraySettings {
  /// Lamp samples along each side of a rect; a power of two, since POV-Ray halves its grid until four samples
  /// are left and weighs unevenly where a half has an odd count.
  int area_grid = 16;
  /// A rect becomes split x split light sources (a power of two): radiosity takes each for a point at its
  /// centre.
  int area_split = 2;
  /// Halvings of the grid that POV-Ray makes even where the corners agree; more finds thinner shadows and
  /// costs more.
  int area_adaptive = 1;
  PovrayRadiosity radiosity;
  /// Photons aimed at mirrors and glass, all lamps together; 0: no caustics.
  int photons = 0;
};

/// n of `+AM2 +Rn`: pixels whose corners differ are halved up to n times, which gives an edge 4^n places, as spp random
/// samples do: the least n with 4^n >= spp, within POV-Ray's [1, 9]. (Its other method, an n x n grid with +AM1, took 2.5 times
/// the time in scene 101 and missed the slivers of a lamp that an edge leaves in a row of pixels: 35 dB against 40.)
int povray_aa_grid(int spp);

/// What of the scene POV-Ray 3.7 cannot do, one sentence each; empty when it can do all of it. What it merely
/// does slowly or with noise is not listed. Reads only the scene, no file.
std::vector<std::string> povray_limits(const scene::Scene& scene, const PovraySettings& settings = {});

/// Writes the scene in POV-Ray's language to `file`, its meshes to `<stem>-meshes.inc` and copies of its
/// textures to
/// `<stem>-texture<i>.<extension>`, all in the folder of `file`: POV-Ray's I/O restrictions let it read the
/// folder that it is started in. Lower the scene first; povray_limits must be empty. InputError when a file
/// cannot be read or written.
void write_povray(const scene::Scene& scene,
                  const PovraySettings& settings,
                  const std::filesystem::path& file);

}  // namespace orbs::adapters
