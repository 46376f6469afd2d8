#include "metrics/edge_shift.h"

#include "image/colour.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace orbs::metrics {

namespace {

constexpr int kMean_px = 2;  // of the mean that is taken off, to each side
constexpr int kBrightest_px =
    3;  // of the brightest light beside a pixel, which covers what it is compared with
constexpr std::size_t kBlock_px_of_edges = 4;

// One channel of an image, less its mean over 5 x 5 px; 0 at the edge of the image.
using Plane = std::vector<double>;

// Sums over 2 n + 1 pixels along rows (step 1) or columns (step width).
Plane sums_along(const Plane& plane, int width, int height, bool is_row) {
  Plane out(plane.size());
  const std::ptrdiff_t step = is_row ? 1 : width;
  for (int y = is_row ? 0 : kMean_px; y < (is_row ? height : height - kMean_px); ++y)
    for (int x = is_row ? kMean_px : 0; x < (is_row ? width - kMean_px : width); ++x) {
      const std::size_t at =
          static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
      const double* const middle = &plane[at];
      double sum = 0;
      for (int i = -kMean_px; i <= kMean_px; ++i) sum += middle[i * step];
      out[at] = sum;
    }
  return out;
}

Plane detail_of(const std::vector<float>& samples, std::size_t channel, int width, int height) {
  constexpr double kCount = (2 * kMean_px + 1) * (2 * kMean_px + 1);
  Plane plane(samples.size() / 3);
  for (std::size_t i = 0; i < plane.size(); ++i) plane[i] = static_cast<double>(samples[3 * i + channel]);
  const Plane sums = sums_along(sums_along(plane, width, height, true), width, height, false);
  for (std::size_t i = 0; i < plane.size(); ++i) plane[i] -= sums[i] / kCount;
  return plane;
}

// The luminance of the reference, not below zero.
Plane light_of(const PairSamples& samples) {
  Plane light(samples.pixel_count());
  for (std::size_t i = 0; i < light.size(); ++i) {
    const float* rgb = &samples.reference[3 * i];
    light[i] = std::max(0.0, image::luminance(static_cast<double>(rgb[0]), static_cast<double>(rgb[1]),
                                              static_cast<double>(rgb[2])));
  }
  return light;
}

double brightest_beside(const Plane& light, int width, std::size_t pixel) {
  const double* const middle = &light[pixel];
  double most = 0;
  for (std::ptrdiff_t v = -kBrightest_px; v <= kBrightest_px; ++v)
    for (std::ptrdiff_t u = -kBrightest_px; u <= kBrightest_px; ++u)
      most = std::max(most, middle[v * width + u]);
  return most;
}

// All that a pixel adds in one channel.
struct Detail {
  std::array<double, 2> middle{};     // slope of the mean of both images, along x and y
  std::array<double, 2> reference{};  // that of the reference
  double difference = 0;
  double variance = 0;  // of the difference
};

struct Details {
  int width = 0;
  std::array<Plane, 3> reference;
  std::array<Plane, 3> result;
};

Detail detail_at(const PairSamples& samples, const Details& details, std::size_t c, std::size_t pixel) {
  const auto& reference = details.reference.at(c);
  const auto& result = details.result.at(c);
  const std::array<std::size_t, 2> steps{1, static_cast<std::size_t>(details.width)};
  Detail detail;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const auto slope = [&](const Plane& plane) {
      return (plane[pixel + steps.at(axis)] - plane[pixel - steps.at(axis)]) / 2;
    };
    detail.reference.at(axis) = slope(reference);
    detail.middle.at(axis) = (slope(reference) + slope(result)) / 2;
  }
  detail.difference = result[pixel] - reference[pixel];
  const std::size_t i = 3 * pixel + c;
  const double of_reference = variance_at(samples.reference_variance, i);
  const double of_result =
      std::max(variance_at(samples.result_variance, i), samples.variance_ratio.at(c) * of_reference);
  detail.variance = samples.area_noise.over_8px.at(c) * (of_result + of_reference);
  return detail;
}

// Calls visit(pixel, weight) for the counted pixels that have all neighbours.
template <typename Visit>
void for_each_inner(const PairSamples& samples, const Plane& weights, Visit visit) {
  for (int y = kBrightest_px; y < samples.height - kBrightest_px; ++y)
    for (int x = kBrightest_px; x < samples.width - kBrightest_px; ++x)
      if (const auto pixel = samples.pixel_at(x, y); samples.included[pixel] != 0)
        visit(pixel, weights[pixel]);
}

// 0 at the edge of the image.
Plane weights_of(const PairSamples& samples, const Plane& light, double mean) {
  constexpr double kFloor = 0.1;  // of the mean: where it is darker, the noise no longer falls with the light
  Plane weights(samples.pixel_count());
  for (int y = kBrightest_px; y < samples.height - kBrightest_px; ++y)
    for (int x = kBrightest_px; x < samples.width - kBrightest_px; ++x) {
      const auto pixel = samples.pixel_at(x, y);
      const double scale = brightest_beside(light, samples.width, pixel) + kFloor * mean;
      weights[pixel] = 1 / (scale * scale);
    }
  return weights;
}

using Vector = std::array<double, 2>;

// The normal equations, and what the differences hold beside noise.
struct Equations {
  std::array<Vector, 2> matrix{};
  Vector product{};
  double beyond_noise = 0;

  double determinant() const { return matrix[0][0] * matrix[1][1] - matrix[0][1] * matrix[1][0]; }
  Vector solved(const Vector& right) const {
    return {(matrix[1][1] * right[0] - matrix[0][1] * right[1]) / determinant(),
            (matrix[0][0] * right[1] - matrix[1][0] * right[0]) / determinant()};
  }
};

Equations equations_of(const PairSamples& samples, const Details& details, const Plane& weights) {
  Equations sums;
  for_each_inner(samples, weights, [&](std::size_t pixel, double weight) {
    for (std::size_t c = 0; c < 3; ++c) {
      const auto detail = detail_at(samples, details, c, pixel);
      for (std::size_t i = 0; i < 2; ++i) {
        sums.product.at(i) += weight * detail.middle.at(i) * detail.difference;
        for (std::size_t k = 0; k < 2; ++k)
          sums.matrix.at(i).at(k) += weight * detail.middle.at(i) * detail.reference.at(k);
      }
      sums.beyond_noise += weight * (detail.difference * detail.difference - detail.variance);
    }
  });
  return sums;
}

// The variances of the shift along each axis: by the noise that is known, and by what the shift leaves.
struct ShiftVariances {
  std::array<PooledVariance, 2> of_noise;
  std::array<PooledVariance, 2> of_remainder;
};

ShiftVariances variances_of(const PairSamples& samples,
                            const Details& details,
                            const Plane& weights,
                            const Equations& equations,
                            const Vector& shift) {
  ShiftVariances variances;
  const auto columns = static_cast<std::size_t>(samples.width) / kBlock_px_of_edges + 1;
  const auto rows = static_cast<std::size_t>(samples.height) / kBlock_px_of_edges + 1;
  std::vector<Vector> blocks(columns * rows);
  for_each_inner(samples, weights, [&](std::size_t pixel, double weight) {
    const auto width = static_cast<std::size_t>(samples.width);
    auto& block = blocks[pixel / width / kBlock_px_of_edges * columns + pixel % width / kBlock_px_of_edges];
    Vector noise{};  // of the pixel, whose channels have much of their noise in common
    for (std::size_t c = 0; c < 3; ++c) {
      const auto detail = detail_at(samples, details, c, pixel);
      const double left = detail.difference - shift[0] * detail.reference[0] - shift[1] * detail.reference[1];
      const auto step = equations.solved({weight * detail.middle[0], weight * detail.middle[1]});
      for (std::size_t i = 0; i < 2; ++i) {
        block.at(i) += step.at(i) * left;
        noise.at(i) += std::fabs(step.at(i)) * std::sqrt(detail.variance);
      }
    }
    for (std::size_t i = 0; i < 2; ++i) variances.of_noise.at(i).add(noise.at(i) * noise.at(i));
  });
  for (const auto& block : blocks)
    for (std::size_t i = 0; i < 2; ++i) variances.of_remainder.at(i).add(block.at(i) * block.at(i));
  return variances;
}

}  // namespace

EdgeShift edge_shift(const PairSamples& samples, double false_alarms) {
  constexpr double kExplained = 1.0 / 3;
  constexpr double kMisfit = 3;  // standard errors
  const auto light = light_of(samples);
  double mean = 0;
  for (const double of_pixel : light) mean += of_pixel / static_cast<double>(light.size());
  if (samples.noise_source == NoiseSource::Scatter || !(mean > 0)) return {};
  Details details{.width = samples.width, .reference = {}, .result = {}};
  for (std::size_t c = 0; c < 3; ++c) {
    details.reference.at(c) = detail_of(samples.reference, c, samples.width, samples.height);
    details.result.at(c) = detail_of(samples.result, c, samples.width, samples.height);
  }
  const auto weights = weights_of(samples, light, mean);
  const auto equations = equations_of(samples, details, weights);
  if (!(equations.determinant() > 0)) return {};
  const auto shift = equations.solved(equations.product);
  const double explained = shift[0] * equations.product[0] + shift[1] * equations.product[1];
  if (!(explained > kExplained * equations.beyond_noise)) return {};
  const auto variances = variances_of(samples, details, weights, equations, shift);
  EdgeShift told;
  for (std::size_t i = 0; i < 2; ++i) {
    const auto& noise = variances.of_noise.at(i);
    const double of_misfit = variances.of_remainder.at(i).sum;
    const double reach = std::max(student_quantile(false_alarms, noise.degrees()) * std::sqrt(noise.sum),
                                  kMisfit * std::sqrt(of_misfit));
    told.px.at(i) = {shift.at(i), shift.at(i) - reach, shift.at(i) + reach};
    const double error = std::sqrt(std::max(noise.sum, of_misfit));
    told.z.at(i) = error > 0 ? std::fabs(shift.at(i)) / error : 0;
  }
  return told;
}

}  // namespace orbs::metrics
