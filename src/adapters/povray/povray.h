#pragma once

#include "adapters/povray/settings.h"
#include "scene/scene.h"

#include <filesystem>
#include <string>
#include <vector>

namespace orbs::adapters {

/// n of `+AM2 +Rn`: pixels whose corners differ are halved up to n times, which gives an edge 4^n places, as
/// spp random samples do: the least n with 4^n >= spp, within [4, 9]. POV-Ray takes 1 to 3 as well, but it
/// weighs the corners by the trapezoid rule, which adds 4^-n / 6 to the variance of a pixel's box filter:
/// edges of scene 305 were 0.22 pixels softer with n = 2 (37.3 dB, 38.9 with 3). And where an edge falls
/// between two places, it may come out 2^-n px off: with n = 3 a row of the lamp of scene 102 that it covers
/// by 0.87 was as bright as a full one, which made small images 1.7 % too bright (0.4 % with 4). Its other
/// method, an n x n
/// grid with +AM1, misses the sliver of a bright light that an edge leaves in a row of pixels: direct light
/// of a Cornell box came to 35.4 dB with n = 3 and to 40.0 with +AM2 +R4 in a fifth of the time.
int povray_aa_grid(int spp);

/// The threshold of that halving, or none: through a lens each ray is already spread over a whole pixel
/// (TracePixel::TraceRayWithFocalBlur of POV-Ray's source), so that halved pixels were blurred by two boxes.
std::string povray_antialiasing(const scene::Scene& scene);

/// Writes the scene in POV-Ray's language to `file`, its meshes to `<stem>-meshes.inc` and copies of its
/// textures to
/// `<stem>-texture<i>.<extension>`, all in the folder of `file`: POV-Ray's I/O restrictions let it read the
/// folder that it is started in. Lower the scene first; povray_limits must be empty. InputError when a file
/// cannot be read or written or when area_grid is no grid that POV-Ray weighs evenly.
void write_povray(const scene::Scene& given,
                  const PovraySettings& settings,
                  const std::filesystem::path& file);

/// POV-Ray's row in the table of exporters.
Exporter povray_exporter();

/// One reason for each thing in the scene that POV-Ray 3.7 cannot draw; empty when there is none. Slow or
/// noisy rendering is no reason. Reads only the scene, no file.
std::vector<std::string> povray_limits(const scene::Scene& scene, const PovraySettings& settings = {});

}  // namespace orbs::adapters
