#include "studies/probe_compare.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <span>

#include <fmt/format.h>

namespace orbs::studies {

namespace {

// Half floats keep 11 bits, a relative error of 5e-4; ids are much farther apart than twice that.
constexpr double kColourTolerance = 1e-3;

using Rgb = std::array<double, 3>;

Rgb rgb_at(const image::Image& image, const std::array<int, 3>& channels, int x, int y) {
  Rgb rgb{};
  for (std::size_t c = 0; c < 3; ++c)
    rgb[c] = static_cast<double>(image.at(x, y, static_cast<std::size_t>(channels[c])));
  return rgb;
}

Rgb colour_of(const ProbeScene& probe, int object) {
  if (object == kNoObject) return {};
  const Vec3d c = probe.objects[static_cast<std::size_t>(object)].radiance;
  return {c.x, c.y, c.z};
}

double largest_difference(const Rgb& a, const Rgb& b) {
  double most = 0;
  for (std::size_t c = 0; c < 3; ++c) most = std::max(most, std::abs(a[c] - b[c]));
  return most;
}

// The object that all points of a pixel see; none if they see several.
std::optional<int> only_object(std::span<const VisibleSurface> surfaces) {
  const auto differs = [&](const VisibleSurface& surface) {
    return surface.object != surfaces.front().object;
  };
  return std::any_of(surfaces.begin(), surfaces.end(), differs) ? std::nullopt
                                                                : std::optional(surfaces.front().object);
}

std::string shown(const ProbeScene& probe, const Rgb& colour) {
  for (int object = kNoObject; object < static_cast<int>(probe.objects.size()); ++object)
    if (largest_difference(colour, colour_of(probe, object)) <= kColourTolerance)
      return object == kNoObject ? "nothing" : probe.objects[static_cast<std::size_t>(object)].name;
  return "a mixture of colours";
}

// A pixel whose colour differs from that of the object that covers it.
struct Suspect {
  int object = kNoObject;  // the expected one
  Pixel at;
  std::string instead;
};

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

std::vector<Mismatch> mismatches_of(const ProbeScene& probe, std::vector<Suspect> suspects) {
  recheck_on_fine_grid(probe, suspects);
  Tally tally;
  for (const auto& suspect : suspects) tally.add(suspect);
  return tally.worst_first();
}

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
struct Interval {
  double low = 0;
  double high = 0;
};
std::optional<Interval> fraction(std::span<const VisibleSurface> surfaces,
                                 float VisibleSurface::*coordinate) {
  constexpr double kTexel = 1.0 / kRampSize;
  constexpr double kMostOfRamp = 0.25;
  const auto [least, most] = std::minmax_element(
      surfaces.begin(), surfaces.end(),
      [&](const VisibleSurface& a, const VisibleSurface& b) { return a.*coordinate < b.*coordinate; });
  const double whole = std::floor(static_cast<double>(*least.*coordinate));
  const Interval range{static_cast<double>(*least.*coordinate) - whole,
                       static_cast<double>(*most.*coordinate) - whole};
  if (range.low < 2 * kTexel || range.high > 1 - 2 * kTexel || range.high - range.low > kMostOfRamp)
    return std::nullopt;
  return range;
}

bool is_within(double value, const Interval& range) {
  // Without interpolation between texels a renderer is off by at most half a texel; the other half allows for
  // the position of the filter.
  constexpr double kTolerance = 1.0 / kRampSize;
  return value >= range.low - kTolerance && value <= range.high + kTolerance;
}

}  // namespace

ProbeFindings compare_id_pass(const ProbeScene& probe,
                              const std::vector<VisibleSurface>& surfaces,
                              const image::Image& image) {
  ProbeFindings findings;
  std::vector<Suspect> suspects;
  for_each_pixel(image, surfaces, [&](int x, int y, std::span<const VisibleSurface> here, const Rgb& colour) {
    const auto object = only_object(here);
    if (!object) return;
    ++findings.compared;
    if (largest_difference(colour, colour_of(probe, *object)) > kColourTolerance)
      suspects.push_back({*object, {x, y}, shown(probe, colour)});
  });
  findings.mismatches = mismatches_of(probe, std::move(suspects));
  return findings;
}

ProbeFindings compare_uv_pass(const ProbeScene& probe,
                              const std::vector<VisibleSurface>& surfaces,
                              const image::Image& image) {
  const int materials = static_cast<int>(probe.scene.materials.size());
  ProbeFindings findings;
  std::vector<Suspect> suspects;
  for_each_pixel(image, surfaces, [&](int x, int y, std::span<const VisibleSurface> here, const Rgb& colour) {
    const auto object = only_object(here);
    if (!object || *object == kNoObject || *object >= materials) return;
    const auto u = fraction(here, &VisibleSurface::u);
    const auto v = fraction(here, &VisibleSurface::v);
    if (!u || !v) return;
    ++findings.compared;
    if (is_within(colour[0], *u) && is_within(colour[1], *v)) return;
    suspects.push_back({*object,
                        {x, y},
                        fmt::format("({:.3f}, {:.3f}) where it has ({:.3f}, {:.3f})", colour[0], colour[1],
                                    (u->low + u->high) / 2, (v->low + v->high) / 2)});
  });
  findings.mismatches = mismatches_of(probe, std::move(suspects));
  return findings;
}

}  // namespace orbs::studies
