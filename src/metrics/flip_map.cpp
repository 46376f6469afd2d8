#include "metrics/flip_map.h"

#include "base/in_double.h"
#include "base/parallel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>

namespace orbs::metrics::flip {

namespace {

constexpr float kQc = 0.7F;
constexpr float kPc = 0.4F;
constexpr float kPt = 0.95F;

// Linear Rec.709 to XYZ over the white of D65, so that white is (1, 1, 1): the matrix of the paper's code
// with its rows divided by their sums.
constexpr double kX0 = 10135552.0, kX1 = 8788810.0, kX2 = 4435075.0;
constexpr double kY0 = 2613072.0, kY1 = 8788810.0, kY2 = 887015.0;
constexpr double kZ0 = 1425312.0, kZ1 = 8788810.0, kZ2 = 70074185.0;

// Row i of the adjugate over the determinant of the same matrix.
std::array<Colour, 3> inverse_matrix() {
  const double x = kX0 + kX1 + kX2;
  const double y = kY0 + kY1 + kY2;
  const double z = kZ0 + kZ1 + kZ2;
  const std::array<std::array<double, 3>, 3> m{
      {{kX0 / x, kX1 / x, kX2 / x}, {kY0 / y, kY1 / y, kY2 / y}, {kZ0 / z, kZ1 / z, kZ2 / z}}};
  std::array<std::array<double, 3>, 3> cofactors{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      cofactors.at(i).at(j) = m.at((i + 1) % 3).at((j + 1) % 3) * m.at((i + 2) % 3).at((j + 2) % 3) -
                              m.at((i + 1) % 3).at((j + 2) % 3) * m.at((i + 2) % 3).at((j + 1) % 3);
  const double determinant =
      m[0][0] * cofactors[0][0] + m[0][1] * cofactors[0][1] + m[0][2] * cofactors[0][2];
  std::array<Colour, 3> inverse{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      inverse.at(i).at(j) = static_cast<float>(cofactors.at(j).at(i) / determinant);
  return inverse;
}

float lab_curve(float t) {
  constexpr float kDelta = 6.0F / 29.0F;
  return t > kDelta * kDelta * kDelta ? in_double::cbrt(t) : t / (3.0F * kDelta * kDelta) + 4.0F / 29.0F;
}

float hyab(const Colour& a, const Colour& b) {
  const float da = a[1] - b[1];
  const float db = a[2] - b[2];
  return std::fabs(a[0] - b[0]) + std::sqrt(da * da + db * db);
}

}  // namespace

Colour to_xyz(const Colour& rgb) {
  const auto row = [&](double r, double g, double b) {
    const double sum = r + g + b;
    return static_cast<float>(r / sum) * rgb[0] + static_cast<float>(g / sum) * rgb[1] +
           static_cast<float>(b / sum) * rgb[2];
  };
  return {row(kX0, kX1, kX2), row(kY0, kY1, kY2), row(kZ0, kZ1, kZ2)};
}

Colour to_rgb_in_gamut(const Colour& xyz) {
  static const auto kInverse = inverse_matrix();
  const auto row = [&](const Colour& m) {
    return std::clamp(m[0] * xyz[0] + m[1] * xyz[1] + m[2] * xyz[2], 0.0F, 1.0F);
  };
  return {row(kInverse[0]), row(kInverse[1]), row(kInverse[2])};
}

Colour to_ycxcz(const Colour& xyz) {
  return {116.0F * xyz[1] - 16.0F, 500.0F * (xyz[0] - xyz[1]), 200.0F * (xyz[1] - xyz[2])};
}

Colour from_ycxcz(const Colour& ycxcz) {
  const float y = (ycxcz[0] + 16.0F) / 116.0F;
  return {y + ycxcz[1] / 500.0F, y, y - ycxcz[2] / 200.0F};
}

Colour to_hunt_lab(const Colour& xyz) {
  const float fx = lab_curve(xyz[0]);
  const float fy = lab_curve(xyz[1]);
  const float fz = lab_curve(xyz[2]);
  const float lightness = 116.0F * fy - 16.0F;
  return {lightness, 0.01F * lightness * 500.0F * (fx - fy), 0.01F * lightness * 200.0F * (fy - fz)};
}

float colour_error(const Colour& a, const Colour& b) {
  static const float kMost =
      in_double::pow(hyab(to_hunt_lab(to_xyz({0, 1, 0})), to_hunt_lab(to_xyz({0, 0, 1}))), kQc);
  const float bend = kPc * kMost;
  const float distance = in_double::pow(hyab(a, b), kQc);
  if (distance < bend) return distance * kPt / bend;
  return kPt + (distance - bend) / (kMost - bend) * (1.0F - kPt);
}

namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kPixelsPerDegree =
    0.7 * 3840 / 0.7 * kPi / 180;  // distance * pixels / width * pi / 180: 67.02
constexpr double kEdgeWidth_deg = 0.082;

using Plane = std::vector<float>;
using Kernel = std::vector<float>;  // odd length, centre in the middle

// Weights at -radius ... radius of sqrt(a sqrt(pi / b)) exp(-pi^2 d^2 / b), d in degrees: two such factors
// make the two-dimensional Gaussian of equation 2.
Kernel sensitivity(double a, double b, int radius) {
  Kernel kernel;
  for (int i = -radius; i <= radius; ++i) {
    const double d = i / kPixelsPerDegree;
    kernel.push_back(
        static_cast<float>(std::sqrt(a * std::sqrt(kPi / b)) * std::exp(-kPi * kPi * d * d / b)));
  }
  return kernel;
}

double sum_of(const Kernel& kernel) {
  double sum = 0;
  for (const float weight : kernel) sum += static_cast<double>(weight);
  return sum;
}

// The filter has weight 1 over all its pixels: both Gaussians of the blue-yellow channel together.
void normalise(std::vector<Kernel>& parts) {
  double total = 0;
  for (const Kernel& part : parts) total += sum_of(part) * sum_of(part);
  const auto factor = static_cast<float>(1.0 / std::sqrt(total));
  for (Kernel& part : parts)
    for (float& weight : part) weight *= factor;
}

void normalise_by_sign(Kernel& kernel) {
  double positive = 0;
  double negative = 0;
  for (const float weight : kernel)
    (weight > 0 ? positive : negative) += std::fabs(static_cast<double>(weight));
  for (float& weight : kernel) weight /= static_cast<float>(weight > 0 ? positive : negative);
}

// Section 4.1.2, table 1: by channel the Gaussians that contrast sensitivity is made of.
std::array<std::vector<Kernel>, 3> sensitivities() {
  const double widest = 0.04;
  const int radius = static_cast<int>(std::ceil(3 * std::sqrt(widest / (2 * kPi * kPi)) * kPixelsPerDegree));
  std::array<std::vector<Kernel>, 3> channels{
      std::vector<Kernel>{sensitivity(1.0, 0.0047, radius)},
      std::vector<Kernel>{sensitivity(1.0, 0.0053, radius)},
      std::vector<Kernel>{sensitivity(34.1, 0.04, radius), sensitivity(13.5, 0.025, radius)}};
  for (auto& channel : channels) normalise(channel);
  return channels;
}

struct FeatureKernels {
  Kernel blur, edge, point;
};

// Section 4.2: a Gaussian and its first two derivatives, positive and negative weights of sum 1 each.
FeatureKernels feature_kernels() {
  const double sigma_px = 0.5 * kEdgeWidth_deg * kPixelsPerDegree;
  const int radius = static_cast<int>(std::ceil(3 * sigma_px));
  FeatureKernels kernels;
  for (int i = -radius; i <= radius; ++i) {
    const double g = std::exp(-i * i / (2 * sigma_px * sigma_px));
    kernels.blur.push_back(static_cast<float>(g));
    kernels.edge.push_back(static_cast<float>(-i * g));
    kernels.point.push_back(static_cast<float>((i * i / (sigma_px * sigma_px) - 1) * g));
  }
  const auto sum = static_cast<float>(sum_of(kernels.blur));
  for (float& weight : kernels.blur) weight /= sum;
  normalise_by_sign(kernels.edge);
  normalise_by_sign(kernels.point);
  return kernels;
}

template <typename Work>
void for_rows(const Grid& grid, Work work) {
  constexpr int kRowsPerTask = 32;
  for_each_index((grid.height + kRowsPerTask - 1) / kRowsPerTask, grid.threads, [&](int task) {
    for (int y = task * kRowsPerTask; y < std::min(grid.height, (task + 1) * kRowsPerTask); ++y) work(y);
  });
}

Plane filter_rows(const Grid& grid, const Plane& in, const Kernel& kernel) {
  Plane out(in.size(), 0.0F);
  const auto width = static_cast<std::size_t>(grid.width);
  const std::size_t radius = kernel.size() / 2;
  for_rows(grid, [&](int y) {
    const float* const row = &in[static_cast<std::size_t>(y) * width];
    float* const to = &out[static_cast<std::size_t>(y) * width];
    std::vector<float> padded(width + 2 * radius, row[0]);
    std::copy(row, row + width, padded.begin() + static_cast<std::ptrdiff_t>(radius));
    std::fill(padded.end() - static_cast<std::ptrdiff_t>(radius), padded.end(), row[width - 1]);
    for (std::size_t k = 0; k < kernel.size(); ++k)
      for (std::size_t x = 0; x < width; ++x) to[x] += kernel[k] * padded[x + k];
  });
  return out;
}

Plane filter_columns(const Grid& grid, const Plane& in, const Kernel& kernel) {
  Plane out(in.size(), 0.0F);
  const auto width = static_cast<std::size_t>(grid.width);
  const int radius = static_cast<int>(kernel.size() / 2);
  for_rows(grid, [&](int y) {
    float* const to = &out[static_cast<std::size_t>(y) * width];
    int row_y = y - radius;
    for (const float weight : kernel) {
      const float* const row = &in[static_cast<std::size_t>(std::clamp(row_y++, 0, grid.height - 1)) * width];
      for (std::size_t x = 0; x < width; ++x) to[x] += weight * row[x];
    }
  });
  return out;
}

using Planes = std::array<Plane, 3>;

Planes ycxcz_planes(const Grid& grid, const std::vector<float>& rgb) {
  Planes planes;
  for (Plane& plane : planes) plane.resize(rgb.size() / 3);
  const auto width = static_cast<std::size_t>(grid.width);
  for_rows(grid, [&](int y) {
    for (std::size_t i = static_cast<std::size_t>(y) * width; i < static_cast<std::size_t>(y + 1) * width;
         ++i) {
      const Colour colour = to_ycxcz(to_xyz({rgb[3 * i], rgb[3 * i + 1], rgb[3 * i + 2]}));
      for (std::size_t c = 0; c < 3; ++c) planes.at(c)[i] = colour.at(c);
    }
  });
  return planes;
}

// What an eye at the given distance still sees of each channel.
Planes seen(const Grid& grid, const Planes& planes) {
  const auto kernels = sensitivities();
  Planes out;
  for (std::size_t c = 0; c < 3; ++c) {
    out.at(c).assign(planes.at(c).size(), 0.0F);
    for (const Kernel& kernel : kernels.at(c)) {
      const Plane part = filter_columns(grid, filter_rows(grid, planes.at(c), kernel), kernel);
      std::transform(part.begin(), part.end(), out.at(c).begin(), out.at(c).begin(), std::plus<>());
    }
  }
  return out;
}

struct Features {
  Plane edge, point;  // magnitudes
};

Plane magnitude(const Plane& a, const Plane& b) {
  Plane out(a.size());
  std::transform(a.begin(), a.end(), b.begin(), out.begin(),
                 [](float x, float y) { return std::sqrt(x * x + y * y); });
  return out;
}

Features features_of(const Grid& grid, const Plane& y) {
  static const auto kKernels = feature_kernels();
  Plane grey(y.size());
  std::transform(y.begin(), y.end(), grey.begin(), [](float value) { return (value + 16.0F) / 116.0F; });
  const Plane blurred = filter_rows(grid, grey, kKernels.blur);
  return {magnitude(filter_columns(grid, filter_rows(grid, grey, kKernels.edge), kKernels.blur),
                    filter_columns(grid, blurred, kKernels.edge)),
          magnitude(filter_columns(grid, filter_rows(grid, grey, kKernels.point), kKernels.blur),
                    filter_columns(grid, blurred, kKernels.point))};
}

}  // namespace

std::vector<float> error_map(const Grid& grid,
                             const std::vector<float>& result,
                             const std::vector<float>& reference) {
  const Planes test = ycxcz_planes(grid, result);
  const Planes right = ycxcz_planes(grid, reference);
  const Planes test_seen = seen(grid, test);
  const Planes right_seen = seen(grid, right);
  const Features test_features = features_of(grid, test[0]);
  const Features right_features = features_of(grid, right[0]);
  std::vector<float> error(test[0].size());
  const auto width = static_cast<std::size_t>(grid.width);
  const auto lab = [](const Planes& p, std::size_t i) {
    return to_hunt_lab(to_xyz(to_rgb_in_gamut(from_ycxcz({p[0][i], p[1][i], p[2][i]}))));
  };
  for_rows(grid, [&](int y) {
    for (std::size_t i = static_cast<std::size_t>(y) * width; i < static_cast<std::size_t>(y + 1) * width;
         ++i) {
      const float colour = colour_error(lab(test_seen, i), lab(right_seen, i));
      const float feature = std::max(std::fabs(test_features.edge[i] - right_features.edge[i]),
                                     std::fabs(test_features.point[i] - right_features.point[i]));
      // Equation 8 with qf = 0.5: a square root.
      error[i] = in_double::pow(colour, 1.0F - std::sqrt(feature / std::sqrt(2.0F)));
    }
  });
  return error;
}

}  // namespace orbs::metrics::flip
