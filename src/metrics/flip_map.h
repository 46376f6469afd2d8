#pragma once

#include <array>
#include <vector>

/// Colours as FLIP compares them; sections are those of the paper named in flip_map.h.
/// P. Andersson, J. Nilsson, T. Akenine-Moller, M. Oskarsson, K. Astrom, M. D. Fairchild, "FLIP: A Difference
/// Evaluator for Alternating Images", Proceedings of the ACM on Computer Graphics and Interactive Techniques
/// 3(2), 2020. Sections and equations in flip_map.cpp are those of this paper.

namespace orbs::metrics::flip {

using Colour = std::array<float, 3>;

/// Linear Rec.709 to XYZ in units of the white of D65, so that white is (1, 1, 1).
Colour to_xyz(const Colour& rgb);

/// The inverse, clamped to [0, 1]: what filtering took out of the screen's gamut goes back to its nearest
/// face (section 4.1.2).
Colour to_rgb_in_gamut(const Colour& xyz);

/// The opponent space Y, Cx, Cz that contrast sensitivity is known in: CIELAB without its cube roots.
Colour to_ycxcz(const Colour& xyz);
Colour from_ycxcz(const Colour& ycxcz);

/// CIELAB with the chroma scaled by the lightness: colours are harder to tell apart in the dark (Hunt
/// effect).
Colour to_hunt_lab(const Colour& xyz);

/// Distance of two such colours, in [0, 1]: HyAB^0.7, whose part below 0.4 of the largest distance of the
/// gamut (green to blue) takes the lower 0.95 of the scale (section 4.1.3).
float colour_error(const Colour& a, const Colour& b);

struct Grid {
  int width = 0;
  int height = 0;
  int threads = 1;  // no result depends on it
};

/// The FLIP error of each pixel, in [0, 1], at 67.02 pixels per degree. Both images are linear Rec.709 in
/// [0, 1], interleaved R, G, B.
std::vector<float> error_map(const Grid& grid,
                             const std::vector<float>& result,
                             const std::vector<float>& reference);

}  // namespace orbs::metrics::flip
