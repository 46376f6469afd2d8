#pragma once

#include <vector>

/// P. Andersson, J. Nilsson, T. Akenine-Moller, M. Oskarsson, K. Astrom, M. D. Fairchild, "FLIP: A Difference
/// Evaluator for Alternating Images", Proceedings of the ACM on Computer Graphics and Interactive Techniques
/// 3(2), 2020. Sections and equations in flip_map.cpp are those of this paper.
namespace orbs::metrics::flip {

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
