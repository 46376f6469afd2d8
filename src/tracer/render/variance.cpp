#include "tracer/render/variance.h"

#include "base/nth.h"
#include "base/random.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace orbs::tracer {

namespace {

// The mean of half the squared differences of so many pixels from their replicates, of three channels, is
// known to a sixth.
constexpr std::size_t kReplicatesOfGroup = 64;

double sum_of(Vec3d v) { return v.x + v.y + v.z; }

// The mean over a pixel and its neighbours. Single values are so rough that pixels have the same one by
// chance.
std::vector<double> smoothed(const std::vector<double>& values, const Film& film) {
  std::vector<double> means;
  means.reserve(values.size());
  for (int y = 0; y < film.height; ++y)
    for (int x = 0; x < film.width; ++x) {
      double sum = 0;
      int count = 0;
      for (int v = std::max(0, y - 1); v <= std::min(film.height - 1, y + 1); ++v)
        for (int u = std::max(0, x - 1); u <= std::min(film.width - 1, x + 1); ++u, ++count)
          sum += values[pixel_index(film, u, v)];
      means.push_back(sum / count);
    }
  return means;
}

std::vector<double> smoothed_light(const Film& film) {
  std::vector<double> light;
  light.reserve(film.pixels.size());
  for (const PixelSums& pixel : film.pixels) light.push_back(sum_of(mean_of(pixel)));
  return smoothed(light, film);
}

std::vector<double> smoothed_scatter(const std::vector<Vec3d>& scatter, const Film& film) {
  std::vector<double> sums;
  sums.reserve(scatter.size());
  for (const Vec3d& s : scatter) sums.push_back(sum_of(s));
  return smoothed(sums, film);
}

// Where a pixel stands among those sorted by scatter, in [0, 1]: groups are equal parts of this. A
// sum of variances is known best from parts that contribute alike, a single pixel from parts that hold as
// many of them.
class Places {
 public:
  explicit Places(const std::vector<double>& noise) : pixels_(static_cast<double>(noise.size())) {
    for (const double n : noise) deviations_ += std::sqrt(n);
  }

  double next(double noise) {
    constexpr double kByCount = 0.5;
    const double by_count = 1 / pixels_;
    const double by_deviation = deviations_ > 0 ? std::sqrt(noise) / deviations_ : by_count;
    place_ += kByCount * by_count + (1 - kByCount) * by_deviation;
    return place_;
  }

 private:
  double pixels_;
  double deviations_ = 0;
  double place_ = 0;
};

// The darker half of a group and the brighter one: with as much scatter, the edge of a dark thing is not as
// even as a bright wall.
std::pair<LikePixels, LikePixels> halves_of(LikePixels group, const std::vector<double>& light) {
  auto& pixels = group.pixels;
  const auto middle = pixels.begin() + static_cast<std::ptrdiff_t>(pixels.size() / 2);
  std::sort(pixels.begin(), pixels.end(), [&](std::uint32_t a, std::uint32_t b) {
    return light[a] != light[b] ? light[a] < light[b] : a < b;
  });
  return {LikePixels{{pixels.begin(), middle}, 0}, LikePixels{{middle, pixels.end()}, 0}};
}

// The variance of a group.
struct Calibration {
  double per_scatter = 0;
  double of_channel = 0;  // where nothing scatters, although the replicates differ
};

// The scatter is that of pixel and replicate: a rare bright sample that only one of them has met counts on
// both sides of the ratio, which it cannot bring above that of independent samples by much.
Calibration calibration_of(const LikePixels& group,
                           const std::vector<Vec3d>& scatter,
                           const Film& film,
                           const std::vector<Vec3d>& scatter_of_replicates,
                           const Film& replicates,
                           std::size_t first_replicate) {
  double squares = 0;  // half the squared differences
  double scattered = 0;
  for (std::size_t k = 0; k < group.replicates; ++k) {
    const std::uint32_t pixel = group.pixels[k];
    const std::size_t replicate = first_replicate + k;
    const Vec3d apart = mean_of(replicates.pixels[replicate]) - mean_of(film.pixels[pixel]);
    squares += sum_of(apart * apart) / 2;
    scattered += sum_of(scatter[pixel] + scatter_of_replicates[replicate]) / 2;
  }
  if (scattered > 0) return {squares / scattered, 0};
  return {0, group.replicates > 0 ? squares / (3 * static_cast<double>(group.replicates)) : 0};
}

}  // namespace

std::vector<Vec3d> scatter_of(const std::vector<std::vector<Vec3f>>& pieces, int count) {
  std::vector<Vec3d> scatter(pieces.empty() ? 0 : pieces.front().size());
  for (std::size_t i = 0; i < scatter.size(); ++i) {
    Vec3d mean{};
    for (int k = 0; k < count; ++k) mean += cast<double>(nth(pieces, k)[i]) / static_cast<double>(count);
    for (int k = 0; k < count; ++k) {
      const Vec3d apart = cast<double>(nth(pieces, k)[i]) - mean;
      scatter[i] += apart * apart / static_cast<double>(count);
    }
  }
  return scatter;
}

std::size_t replicate_count(std::size_t pixels) {
  constexpr std::size_t kFewest = 8 * kReplicatesOfGroup;
  return std::min(pixels, std::max(kFewest, pixels / 16));
}

std::vector<LikePixels> like_pixels(const Film& film, const std::vector<Vec3d>& scatter, std::uint64_t seed) {
  const std::vector<double> noise = smoothed_scatter(scatter, film);
  const std::vector<double> light = smoothed_light(film);
  std::vector<std::uint32_t> order(noise.size());
  std::iota(order.begin(), order.end(), 0U);
  const auto by_hash = [seed](std::uint32_t a, std::uint32_t b) { return mix(seed, a) < mix(seed, b); };
  // Equal ones in the order of the hash, so that a group that ends among them takes some from everywhere.
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return noise[a] != noise[b] ? noise[a] < noise[b] : by_hash(a, b);
  });
  const std::size_t replicates = replicate_count(noise.size());
  const std::size_t levels = std::max<std::size_t>(1, replicates / (2 * kReplicatesOfGroup));
  std::vector<LikePixels> by_scatter(levels);
  Places places(noise);
  for (const std::uint32_t pixel : order) {
    const double place = places.next(noise[pixel]) * static_cast<double>(levels);
    by_scatter[std::min(levels - 1, static_cast<std::size_t>(place))].pixels.push_back(pixel);
  }
  std::vector<LikePixels> groups;
  for (LikePixels& level : by_scatter) {
    auto [dark, bright] = halves_of(std::move(level), light);
    for (LikePixels* group : {&dark, &bright}) {
      std::sort(group->pixels.begin(), group->pixels.end(), by_hash);
      group->replicates = std::min(group->pixels.size(), replicates / (2 * levels));
      groups.push_back(std::move(*group));
    }
  }
  return groups;
}

Film film_of_replicates(const Film& film, const std::vector<LikePixels>& groups) {
  std::vector<CameraPixel> pixels;
  for (const LikePixels& group : groups)
    for (std::size_t k = 0; k < group.replicates; ++k) {
      const auto pixel = static_cast<int>(group.pixels[k]);
      pixels.push_back({pixel % film.width, pixel / film.width});
    }
  Film replicates = make_film(static_cast<int>(pixels.size()), 1);
  replicates.camera_pixels = std::move(pixels);
  replicates.pieces.assign(film.pieces.size(), std::vector<Vec3f>(replicates.pixels.size()));
  return replicates;
}

std::vector<Vec3d> variances_of_means(const Film& film,
                                      const std::vector<Vec3d>& scatter,
                                      const std::vector<LikePixels>& groups,
                                      const Film& replicates,
                                      WholePieces pieces) {
  const std::vector<Vec3d> scatter_of_replicates = scatter_of(replicates.pieces, pieces.count);
  std::vector<Vec3d> variances(film.pixels.size());
  std::size_t first_replicate = 0;
  for (const LikePixels& group : groups) {
    const auto found =
        calibration_of(group, scatter, film, scatter_of_replicates, replicates, first_replicate);
    for (const std::uint32_t pixel : group.pixels)
      variances[pixel] =
          scatter[pixel] * found.per_scatter + Vec3d{found.of_channel, found.of_channel, found.of_channel};
    first_replicate += group.replicates;
  }
  if (film.splat_pieces.empty()) return variances;
  const std::vector<Vec3d> of_splats = scatter_of(film.splat_pieces, pieces.count);
  for (std::size_t i = 0; i < variances.size(); ++i)
    variances[i] += of_splats[i] * (pieces.share / (pieces.count - 1));
  return variances;
}

bool float_holds_variances(const Film& film, const std::vector<Vec3d>& variances) {
  double largest = 0;
  double brightest = 0;
  for (std::size_t i = 0; i < variances.size(); ++i) {
    const Vec3d mean = mean_of(film, i);
    largest = std::max({largest, variances[i].x, variances[i].y, variances[i].z});
    brightest = std::max({brightest, mean.x, mean.y, mean.z});
  }
  const double colour_rounding = brightest * 0x1p-24;
  constexpr double kMost = std::numeric_limits<float>::max();
  constexpr double kLeast = std::numeric_limits<float>::min() * 0x1p24;  // smaller ones still count beside it
  return largest <= colour_rounding * colour_rounding || (largest >= kLeast && largest <= kMost);
}

}  // namespace orbs::tracer
