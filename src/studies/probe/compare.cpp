#include "studies/probe/compare.h"

#include "base/nth.h"
#include "image/image.h"
#include "studies/probe/primary_visibility.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include <fmt/format.h>

namespace orbs::studies {

namespace {

// How far these channels ("RGB") of a pixel may lie from what they should be because of noise: eight times
// the median standard deviation at these pixels, of the noisiest channel. The median, since a few pixels at
// edges that are out of place are no noise; eight, since two seeds underestimate it 1.5-fold, and a bright
// pixel may be twice as noisy as most. 0 for an image without variances.
double noise_tolerance(const image::Image& image,
                       const std::vector<Pixel>& pixels,
                       std::string_view channels) {
  constexpr double kDeviations = 8;
  if (pixels.empty()) return 0;
  double most = 0;
  for (const char name : channels) {
    const int channel = image::channel_index(image, fmt::format("variance.{}", name));
    if (channel < 0) return 0;
    std::vector<float> variances;
    for (const Pixel& pixel : pixels)
      variances.push_back(image.at(pixel.x, pixel.y, static_cast<std::size_t>(channel)));
    const auto median = variances.begin() + std::ssize(variances) / 2;
    std::nth_element(variances.begin(), median, variances.end());
    most = std::max(most, std::sqrt(static_cast<double>(*median)));
  }
  return kDeviations * most;
}

// Half floats keep 11 bits, a relative error of 5e-4; ids are much farther apart than twice that.
constexpr double kColourTolerance = 1e-3;

// What a pixel shows that has the colour of no object.
constexpr const char* kMixture = "a mixture of colours";

using Rgb = std::array<double, 3>;

Rgb rgb_at(const image::Image& image, const std::array<int, 3>& channels, int x, int y) {
  Rgb rgb{};
  for (std::size_t c = 0; c < 3; ++c)
    rgb[c] = static_cast<double>(image.at(x, y, static_cast<std::size_t>(channels[c])));
  return rgb;
}

Rgb colour_of(const ProbeScene& probe, int object) {
  if (object == kNoObject) return {};
  const Vec3d c = nth(probe.objects, object).radiance;
  return {c.x, c.y, c.z};
}

double largest_difference(const Rgb& a, const Rgb& b) {
  double most = 0;
  for (std::size_t c = 0; c < 3; ++c) most = std::max(most, std::abs(a[c] - b[c]));
  return most;
}

}  // namespace

std::optional<int> only_object(std::span<const VisibleSurface> surfaces) {
  const auto differs = [&](const VisibleSurface& surface) {
    return surface.object != surfaces.front().object;
  };
  return std::any_of(surfaces.begin(), surfaces.end(), differs) ? std::nullopt
                                                                : std::optional(surfaces.front().object);
}

namespace {

// How far apart the two colours are that are most alike, those of the background and of all objects.
double least_distance(const ProbeScene& probe) {
  double least = 1;
  for (int a = kNoObject; a < static_cast<int>(probe.objects.size()); ++a)
    for (int b = a + 1; b < static_cast<int>(probe.objects.size()); ++b)
      least = std::min(least, largest_difference(colour_of(probe, a), colour_of(probe, b)));
  return least;
}

std::string shown(const ProbeScene& probe, const Rgb& colour, double tolerance) {
  for (int object = kNoObject; object < static_cast<int>(probe.objects.size()); ++object)
    if (largest_difference(colour, colour_of(probe, object)) <= tolerance)
      return object == kNoObject ? "nothing" : nth(probe.objects, object).name;
  return kMixture;
}

// Leaves and needles can be narrower than the spacing of the grid. If few pixels mismatch, they are tested
// again with a spacing of 1/64 of a pixel, and those that show more than one object are dropped.
void recheck_on_fine_grid(const ProbeScene& probe, std::vector<Suspect>& suspects) {
  constexpr std::size_t kFew = 64;
  constexpr VisibilityGrid kFine{64, 0.02};
  if (suspects.size() > kFew) return;
  std::vector<Pixel> pixels;
  for (const auto& suspect : suspects) pixels.push_back(suspect.at);
  const auto surfaces = visible_surfaces_of_pixels(probe.scene, pixels, kFine, 1);
  const std::size_t each = kFine.per_side * kFine.per_side;
  std::vector<Suspect> kept;
  for (std::size_t i = 0; i < suspects.size(); ++i)
    if (only_object(std::span(surfaces).subspan(i * each, each))) kept.push_back(suspects[i]);
  suspects = std::move(kept);
}

// Counts mismatching pixels by object.
class Tally {
 public:
  void add(const Suspect& suspect) {
    auto& one = by_object_[suspect.object];
    if (one.mismatch.pixels++ == 0) one.mismatch = {suspect.object, 1, suspect.at.x, suspect.at.y, {}};
    ++one.instead[suspect.instead];
  }
  std::vector<Mismatch> worst_first() const {
    std::vector<Mismatch> all;
    for (const auto& [object, one] : by_object_) {
      all.push_back(one.mismatch);
      const auto fewer = [](const auto& a, const auto& b) { return a.second < b.second; };
      all.back().instead = std::max_element(one.instead.begin(), one.instead.end(), fewer)->first;
    }
    const auto worse = [](const Mismatch& a, const Mismatch& b) { return a.pixels > b.pixels; };
    std::stable_sort(all.begin(), all.end(), worse);
    return all;
  }

 private:
  struct OfObject {
    Mismatch mismatch;
    std::map<std::string, int> instead;
  };
  std::map<int, OfObject> by_object_;
};

}  // namespace

std::vector<Mismatch> mismatches_of(const ProbeScene& probe, std::vector<Suspect> suspects) {
  recheck_on_fine_grid(probe, suspects);
  Tally tally;
  for (const auto& suspect : suspects) tally.add(suspect);
  return tally.worst_first();
}

namespace {

template <typename Look>
void for_each_pixel(const image::Image& image, const std::vector<VisibleSurface>& surfaces, Look look) {
  const std::array<int, 3> channels{image::channel_index(image, "R"), image::channel_index(image, "G"),
                                    image::channel_index(image, "B")};
  const std::size_t each = surfaces.size() / image.pixel_count();
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const auto pixel =
          static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x);
      look(x, y, std::span(surfaces).subspan(pixel * each, each), rgb_at(image, channels, x, y));
    }
}

// The range of a coordinate's fractional part in a pixel. None if it wraps around inside the pixel, if the
// ramp's last texel is interpolated with its first, or if the pixel covers so much of the ramp that the
// result depends on the filter.
struct FractionRange {
  double low = 0;
  double high = 0;
};
std::optional<FractionRange> fraction(std::span<const VisibleSurface> surfaces,
                                      float VisibleSurface::*coordinate) {
  constexpr double kTexel = 1.0 / kRampSize;
  constexpr double kMostOfRamp = 0.25;
  const auto [least, most] = std::minmax_element(
      surfaces.begin(), surfaces.end(),
      [&](const VisibleSurface& a, const VisibleSurface& b) { return a.*coordinate < b.*coordinate; });
  const double whole = std::floor(static_cast<double>(*least.*coordinate));
  const FractionRange range{static_cast<double>(*least.*coordinate) - whole,
                            static_cast<double>(*most.*coordinate) - whole};
  if (range.low < 2 * kTexel || range.high > 1 - 2 * kTexel || range.high - range.low > kMostOfRamp)
    return std::nullopt;
  return range;
}

bool is_within(double value, const FractionRange& range, double noise) {
  // Without interpolation between texels a renderer is off by at most half a texel; the other half allows for
  // the position of the filter.
  const double tolerance = 1.0 / kRampSize + noise;
  return value >= range.low - tolerance && value <= range.high + tolerance;
}

// A pixel of the id pass that one object covers.
struct IdPixel {
  Pixel at;
  int object = kNoObject;
  Rgb colour{};
};

// A pixel of the uv pass whose coordinates are known well enough.
struct UvPixel {
  Pixel at;
  int object = kNoObject;
  FractionRange u;
  FractionRange v;
  Rgb colour{};
};

template <typename Compared>
double noise_at(const image::Image& image, const std::vector<Compared>& compared, std::string_view channels) {
  std::vector<Pixel> pixels;
  for (const auto& one : compared) pixels.push_back(one.at);
  return noise_tolerance(image, pixels, channels);
}

// Rays slip between two triangles in renderers whose intersection is not watertight: of 8500 pixels of scene
// 078-remap that Mitsuba renders with its own kd-tree, one shows what lies behind. What is out of its place
// shows in more pixels, or as another object.
bool are_cracks(const std::vector<Mismatch>& mismatches, int compared) {
  constexpr int kPixelsPerCrack = 4096;
  int pixels = 0;
  for (const auto& mismatch : mismatches) pixels += mismatch.pixels;
  const auto is_mixture = [](const Mismatch& mismatch) { return mismatch.instead == kMixture; };
  return pixels <= compared / kPixelsPerCrack &&
         std::all_of(mismatches.begin(), mismatches.end(), is_mixture);
}

// Noise falls with the square root of the samples.
double times_the_samples(double noise, double bearable) { return std::pow(noise / bearable, 2); }

}  // namespace

ProbeFindings compare_id_pass(const ProbeScene& probe,
                              const std::vector<VisibleSurface>& surfaces,
                              const image::Image& image) {
  std::vector<IdPixel> compared;
  for_each_pixel(image, surfaces, [&](int x, int y, std::span<const VisibleSurface> here, const Rgb& colour) {
    if (const auto object = only_object(here)) compared.push_back({{x, y}, *object, colour});
  });
  ProbeFindings findings;
  findings.compared = static_cast<int>(compared.size());
  const double noise = noise_at(image, compared, "RGB");
  // Two colours must not be taken for each other.
  const double bearable = 0.5 * least_distance(probe) - kColourTolerance;
  if (noise > bearable) {
    findings.needed_samples = times_the_samples(noise, bearable);
    return findings;
  }
  std::vector<Suspect> suspects;
  const double tolerance = kColourTolerance + noise;
  for (const auto& pixel : compared)
    if (largest_difference(pixel.colour, colour_of(probe, pixel.object)) > tolerance)
      suspects.push_back({pixel.object, pixel.at, shown(probe, pixel.colour, tolerance)});
  findings.mismatches = mismatches_of(probe, std::move(suspects));
  if (are_cracks(findings.mismatches, findings.compared)) {
    for (const auto& mismatch : findings.mismatches) findings.cracks += mismatch.pixels;
    findings.mismatches.clear();
  }
  return findings;
}

image::Image ratios_to_blue(const image::Image& image) {
  constexpr float kLeast = 0.02F;  // of the light of the environment; the rest is noise, or rounding
  auto ratios = image::select_rgb(image, "");
  for (std::size_t i = 0; i < ratios.pixels.size(); i += 3) {
    const float blue = ratios.pixels[i + 2];
    const bool is_lit = blue >= kLeast;
    for (std::size_t c = 0; c < 3; ++c) ratios.pixels[i + c] = is_lit ? ratios.pixels[i + c] / blue : 0;
  }
  return ratios;
}

ProbeFindings compare_uv_pass(const ProbeScene& probe,
                              const std::vector<VisibleSurface>& surfaces,
                              const image::Image& image,
                              Ramp ramp,
                              double step) {
  const int materials = static_cast<int>(probe.scene.materials.size());
  std::vector<UvPixel> compared;
  for_each_pixel(image, surfaces, [&](int x, int y, std::span<const VisibleSurface> here, const Rgb& colour) {
    const auto object = only_object(here);
    if (!object || *object == kNoObject || *object >= materials) return;
    if (ramp == Ramp::Reflected && colour[2] != 1) return;
    const auto u = fraction(here, &VisibleSurface::u);
    const auto v = fraction(here, &VisibleSurface::v);
    if (u && v) compared.push_back({{x, y}, *object, *u, *v, colour});
  });
  ProbeFindings findings;
  findings.compared = static_cast<int>(compared.size());
  constexpr double kBearable =
      0.05;  // of the ramp's length: exchanged or mirrored coordinates differ by more
  // Red and green differ between the points of a pixel, blue is 1 at all of them. Of ratios blue is 1
  // whatever the noise, and a channel that has noise of its own shows it there.
  const double noise = noise_at(image, compared, ramp == Ramp::Emitted ? "B" : "RG");
  if (noise > kBearable) {
    findings.needed_samples = times_the_samples(noise, kBearable);
    return findings;
  }
  std::vector<Suspect> suspects;
  for (const auto& pixel : compared)
    if (!is_within(pixel.colour[0], pixel.u, noise + step) ||
        !is_within(pixel.colour[1], pixel.v, noise + step))
      suspects.push_back(
          {pixel.object, pixel.at,
           fmt::format("({:.3f}, {:.3f}) where it has ({:.3f}, {:.3f})", pixel.colour[0], pixel.colour[1],
                       (pixel.u.low + pixel.u.high) / 2, (pixel.v.low + pixel.v.high) / 2)});
  findings.mismatches = mismatches_of(probe, std::move(suspects));
  return findings;
}

}  // namespace orbs::studies
