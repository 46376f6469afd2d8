#include "adapters/hydra/ies.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>
#include <vector>

#include <fmt/format.h>

namespace orbs::adapters::hydra {

namespace {

// Half a degree and two degrees: profiles are measured in steps of 0.5 to 5 degrees.
constexpr int kVertical = 360;
constexpr int kHorizontal = 180;

// The parser reads lines of at most 132 characters.
constexpr int kPerLine = 10;

void append_list(std::string& text, const std::vector<double>& numbers) {
  for (std::size_t i = 0; i < numbers.size(); ++i)
    fmt::format_to(std::back_inserter(text), "{:.6g}{}", numbers[i],
                   i + 1 == numbers.size() || (i + 1) % kPerLine == 0 ? "\n" : " ");
}

std::vector<double> even_angles(int count, double last_deg) {
  std::vector<double> angles;
  for (int i = 0; i < count; ++i) angles.push_back(last_deg * i / (count - 1));
  return angles;
}

// The factor by which a matrix that turns or mirrors scales; nothing for one that changes angles. Matrices
// may be given with six digits.
std::optional<double> even_scale(const Mat4& matrix) {
  constexpr double kRounding = 1e-5;
  std::array<Vec3d, 3> axes{transform_direction(matrix, {1, 0, 0}), transform_direction(matrix, {0, 1, 0}),
                            transform_direction(matrix, {0, 0, 1})};
  const double size = length(axes[0]);
  for (std::size_t i = 0; i < axes.size(); ++i)
    for (std::size_t j = 0; j <= i; ++j)
      if (std::abs(dot(axes[i], axes[j]) - (i == j ? size * size : 0)) > kRounding * size * size)
        return std::nullopt;
  return size;
}

// Without the translation.
Mat4 linear_part(Mat4 matrix) {
  for (std::size_t i = 0; i < 3; ++i) matrix(i, 3) = 0;
  return matrix;
}

Mat4 transposed(const Mat4& matrix) {
  Mat4 out;
  for (std::size_t row = 0; row < 4; ++row)
    for (std::size_t column = 0; column < 4; ++column) out(row, column) = matrix(column, row);
  return out;
}

}  // namespace

IesGrid ies_grid(const scene::IesProfile& profile) {
  std::string candela;
  double peak = 0;
  for (int h = 0; h < kHorizontal; ++h) {
    std::vector<double> plane;
    for (int v = 0; v < kVertical; ++v)
      plane.push_back(candela_at(profile, 180 * (v + 0.5) / kVertical, 360 * (h + 0.5) / kHorizontal) /
                      profile.max_candela);
    peak = std::max(peak, *std::max_element(plane.begin(), plane.end()));
    append_list(candela, plane);
  }
  std::string text =
      fmt::format("IESNA:LM-63-1995\nTILT=NONE\n1 -1 1 {} {} 1 2 0 0 0\n1 1 0\n", kVertical, kHorizontal);
  append_list(text, even_angles(kVertical, 180));
  append_list(text, even_angles(kHorizontal, 360));
  return {text + candela, peak};
}

std::string ies_limit(const scene::IesUse& use, const Mat4& light) {
  if (!even_scale(light * use.matrix) || !even_scale(light))
    return "has an IES profile and is scaled unevenly: HydraCore3 looks profiles up in directions that only turn";
  if (!(ies_grid(*use.profile).peak > 0))
    return "has an IES profile whose light is narrower than the grid of half a degree that is written for HydraCore3";
  return "";
}

// With L and M the linear parts of the light's matrix and the profile's, a direction d in the world is
// (L M)^-1 d in the profile, and HydraCore3 looks up D L^T W d for the matrix W, where D turns its azimuths
// into ours. So W is L^-T D (L M)^-1, and for a rotation L that is L D M^-1 L^T. Lengths must stay, as it
// takes the polar angle from one component.
Mat4 ies_matrix(const scene::IesUse& use, const Mat4& light) {
  const Mat4 placed = linear_part(light);
  const Mat4 profile = linear_part(light * use.matrix);
  const double scale = even_scale(profile).value();
  return transposed(inverse(placed).value()) * scaling({-1, 1, 1}) * scaling({scale, scale, scale}) *
         inverse(profile).value();
}

}  // namespace orbs::adapters::hydra
