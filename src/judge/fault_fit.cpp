#include "judge/fault_fit.h"

#include "base/nth.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace orbs::judge {

namespace {

using image::Image;

std::size_t pixel_at(const Image& image, int x, int y) {
  return static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x);
}

// Calls visit(pixel, weight) for each counted pixel of the rectangle.
template <typename Visit>
void for_each_counted(const FitSamples& samples, const Rectangle& where, Visit visit) {
  for (int y = where.y0; y < where.y1; ++y)
    for (int x = where.x0; x < where.x1; ++x)
      if (const auto pixel = pixel_at(samples.result, x, y); samples.weight[pixel] > 0)
        visit(pixel, static_cast<double>(samples.weight[pixel]));
}

double sample(const Image& image, std::size_t pixel, std::size_t c) {
  return static_cast<double>(image.pixels[3 * pixel + c]);
}

// The mean over 5 x 5 px of the light of both images.
std::vector<float> light_around(const Image& result, const Image& reference) {
  constexpr int kReach_px = 2;
  std::vector<float> light(result.pixel_count());
  for (std::size_t pixel = 0; pixel < light.size(); ++pixel)
    for (std::size_t i = 3 * pixel; i < 3 * pixel + 3; ++i)
      light[pixel] += (std::fabs(result.pixels[i]) + std::fabs(reference.pixels[i])) / 6;
  std::vector<float> around(light.size());
  for (int y = 0; y < result.height; ++y)
    for (int x = 0; x < result.width; ++x) {
      float sum = 0;
      int count = 0;
      for (int v = std::max(0, y - kReach_px); v <= std::min(result.height - 1, y + kReach_px); ++v)
        for (int u = std::max(0, x - kReach_px); u <= std::min(result.width - 1, x + kReach_px); ++u) {
          sum += light[pixel_at(result, u, v)];
          ++count;
        }
      around[pixel_at(result, x, y)] = sum / static_cast<float>(count);
    }
  return around;
}

// The weighted errors that a candidate leaves, by pixel and channel; 0 where a pixel does not count.
struct Errors {
  std::vector<float> left;
  std::size_t count = 0;  // of samples
  double squares = 0;     // mean
  double carriers = 1;    // (sum d^2)^2 / sum d^4: how many samples carry the mean
};

Errors errors_of(const FitSamples& samples, const Image& candidate, const Rectangle& where) {
  Errors errors;
  errors.left.resize(samples.result.pixels.size());
  double sum = 0;
  double fourth = 0;
  for_each_counted(samples, where, [&](std::size_t pixel, double weight) {
    for (std::size_t c = 0; c < 3; ++c) {
      const double d = weight * (sample(samples.result, pixel, c) - sample(candidate, pixel, c));
      errors.left[3 * pixel + c] = static_cast<float>(d);
      sum += d * d;
      fourth += d * d * d * d;
      ++errors.count;
    }
  });
  if (errors.count > 0) errors.squares = sum / static_cast<double>(errors.count);
  if (fourth > 0) errors.carriers = std::max(1.0, sum * sum / fourth);
  return errors;
}

// Mean of d(x) d(x + 1), of neighbours in both directions: zero for independent noise.
double shared_by_neighbours(const FitSamples& samples, const Errors& errors, const Rectangle& where) {
  double sum = 0;
  std::size_t count = 0;
  const auto add = [&](std::size_t a, std::size_t b) {
    if (samples.weight[a] <= 0 || samples.weight[b] <= 0) return;
    for (std::size_t c = 0; c < 3; ++c)
      sum += static_cast<double>(errors.left[3 * a + c]) * static_cast<double>(errors.left[3 * b + c]);
    count += 3;
  };
  for (int y = where.y0; y < where.y1; ++y)
    for (int x = where.x0; x < where.x1; ++x) {
      const auto pixel = pixel_at(samples.result, x, y);
      if (x + 1 < where.x1) add(pixel, pixel + 1);
      if (y + 1 < where.y1) add(pixel, pixel_at(samples.result, x, y + 1));
    }
  return count == 0 ? 0 : sum / static_cast<double>(count);
}

// Mean of the squared block means, less what independent noise of the same squares gives. For an error a that
// a block of n px has in common, sum^2 / n less the mean square is (n - 1) a^2.
double shared_by_blocks(const FitSamples& samples,
                        const Errors& errors,
                        const Rectangle& where,
                        int side_px) {
  double squares_of_means = 0;
  double of_noise = 0;
  std::size_t pixels = 0;
  for (int y = where.y0; y < where.y1; y += side_px)
    for (int x = where.x0; x < where.x1; x += side_px) {
      std::array<double, 3> sum{};
      double squares = 0;
      std::size_t count = 0;
      const Rectangle block{x, y, std::min(x + side_px, where.x1), std::min(y + side_px, where.y1)};
      for_each_counted(samples, block, [&](std::size_t pixel, double) {
        ++count;
        for (std::size_t c = 0; c < 3; ++c) {
          const double d = static_cast<double>(errors.left[3 * pixel + c]);
          sum.at(c) += d;
          squares += d * d;
        }
      });
      if (count < 2) continue;
      const auto n = static_cast<double>(count);
      for (const double s : sum) squares_of_means += s * s / (n - 1);
      of_noise += squares / (n - 1);
      pixels += count;
    }
  if (pixels == 0) return 0;
  return (squares_of_means - of_noise) / (3 * static_cast<double>(pixels));
}

// By how much the error is larger where the candidate changes the reference more, half of each block.
double larger_where_changed(const FitSamples& samples,
                            const Image& candidate,
                            const Errors& errors,
                            const Rectangle& where) {
  constexpr int kSide_px = 8;
  double more = 0;
  std::size_t count = 0;
  std::vector<std::pair<double, double>> by_change;  // change, error
  for (int y = where.y0; y < where.y1; y += kSide_px)
    for (int x = where.x0; x < where.x1; x += kSide_px) {
      by_change.clear();
      const Rectangle block{x, y, std::min(x + kSide_px, where.x1), std::min(y + kSide_px, where.y1)};
      for_each_counted(samples, block, [&](std::size_t pixel, double weight) {
        for (std::size_t c = 0; c < 3; ++c) {
          const double d = static_cast<double>(errors.left[3 * pixel + c]);
          by_change.emplace_back(
              weight * std::fabs(sample(candidate, pixel, c) - sample(samples.reference, pixel, c)), d * d);
        }
      });
      const auto half = static_cast<std::ptrdiff_t>(by_change.size() / 2);
      std::nth_element(by_change.begin(), by_change.begin() + half, by_change.end());
      double low = 0;
      double high = 0;
      for (std::ptrdiff_t i = 0; i < static_cast<std::ptrdiff_t>(by_change.size()); ++i)
        (i < half ? low : high) += nth(by_change, i).second;
      more += (high - low) / 2;
      count += by_change.size();
    }
  return count == 0 ? 0 : more / static_cast<double>(count);
}

}  // namespace

FitSamples fit_samples(const Image& result, const Image& reference, const metrics::Mask& mask) {
  constexpr double kFloor = 0.1;
  FitSamples samples{image::select_rgb(result, ""), image::select_rgb(reference, ""), {}};
  const auto included = metrics::included_pixels(mask, result.width, result.height);
  samples.weight = light_around(samples.result, samples.reference);
  double mean = 0;
  for (const float light : samples.weight) mean += static_cast<double>(light);
  mean /= static_cast<double>(samples.weight.size());
  for (std::size_t pixel = 0; pixel < included.size(); ++pixel) {
    const double light = static_cast<double>(samples.weight[pixel]) + kFloor * mean;
    samples.weight[pixel] = included[pixel] == 0 || light <= 0 ? 0.0F : static_cast<float>(1 / light);
  }
  return samples;
}

Fit fit_of(const FitSamples& samples, const Image& candidate, const Rectangle& where) {
  Fit fit;
  const auto better = advantage(samples, samples.reference, candidate, where);
  std::size_t count = 0;
  for_each_counted(samples, where, [&](std::size_t pixel, double weight) {
    for (std::size_t c = 0; c < 3; ++c) {
      const double left = weight * (sample(samples.result, pixel, c) - sample(candidate, pixel, c));
      fit.after += left * left;
      ++count;
    }
  });
  if (count > 0) fit.after /= static_cast<double>(count);
  fit.before = fit.after + better.value;
  fit.standard_error = better.standard_error;
  return fit;
}

// With m = w (b - a) and d = w (result - b) the error of a is (d + m)^2, which exceeds d^2 by m^2 + 2 m d. If
// b is right, d is noise, and the variance of the sum of 2 m d is that of 4 m^2 d^2.
Advantage advantage(const FitSamples& samples, const Image& a, const Image& b, const Rectangle& where) {
  double sum = 0;
  double variance = 0;
  std::size_t count = 0;
  for_each_counted(samples, where, [&](std::size_t pixel, double weight) {
    for (std::size_t c = 0; c < 3; ++c) {
      const double m = weight * (sample(b, pixel, c) - sample(a, pixel, c));
      const double d = weight * (sample(samples.result, pixel, c) - sample(b, pixel, c));
      sum += m * m + 2 * m * d;
      variance += 4 * m * m * d * d;
      ++count;
    }
  });
  if (count == 0) return {};
  const auto n = static_cast<double>(count);
  return {sum / n, std::sqrt(variance) / n};
}

Unexplained unexplained_by(const FitSamples& samples,
                           const Image& candidate,
                           const Rectangle& where,
                           bool averages_noise) {
  constexpr double kDoubts = 4;
  const auto errors = errors_of(samples, candidate, where);
  double shared = averages_noise ? larger_where_changed(samples, candidate, errors, where)
                                 : shared_by_neighbours(samples, errors, where);
  if (!averages_noise)
    for (const int side_px : {2, 4, 8})
      shared = std::max(shared, shared_by_blocks(samples, errors, where, side_px));
  const double doubt = errors.squares / std::sqrt(errors.carriers);
  return {std::max(0.0, shared - kDoubts * doubt), doubt};
}

}  // namespace orbs::judge
