#include "metrics/patterns.h"

#include "base/statistics.h"
#include "image/colour.h"
#include "metrics/amplitude.h"
#include "metrics/edge_shift.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <numbers>
#include <utility>

#include <fmt/format.h>

namespace orbs::metrics {

namespace {

// Numbers of four pixels beside each other. An operation on them is one instruction, and gives each the bits
// that it would have alone.
constexpr int kLanes = 4;
using Lanes = double __attribute__((vector_size(32)));
using Rgb = std::array<Lanes, 3>;

Lanes all(double value) { return Lanes{} + value; }

// The reference around four pixels, in radiance over the mean luminance of the image. The pixel itself is
// left out: its noise is in the difference too, and would pass for a pattern.
struct Site {
  Rgb ring{};     // mean of the 8 neighbours
  Rgb slope_x{};  // per px
  Rgb slope_y{};
  Rgb bend{};                              // mean of the 16 pixels around the ring - ring
  Lanes luminance{};                       // of the ring
  Lanes x{}, y{};                          // -1 to 1 from edge to edge
  Lanes from_centre_x{}, from_centre_y{};  // px
  Lanes sign_of_column{}, sign_of_row{};   // -1 where it is odd, 1 where it is even
};

struct Row {
  Pattern pattern;
  Rgb (*at)(const Site&);
  bool is_of_colour =
      false;  // tested without what all channels share, which is most of a path tracer's noise
};

Rgb scaled(const Rgb& rgb, Lanes factor) { return {rgb[0] * factor, rgb[1] * factor, rgb[2] * factor}; }

// a times x + b times y.
Rgb sum_of(const Rgb& x, Lanes a, const Rgb& y, Lanes b) {
  return {a * x[0] + b * y[0], a * x[1] + b * y[1], a * x[2] + b * y[2]};
}

Rgb minus(const Rgb& rgb, Lanes level) { return {rgb[0] - level, rgb[1] - level, rgb[2] - level}; }

// Perpendicular to the grey axis and to the colour, as long as what the colour has beside grey.
Rgb turned_in_hue(const Rgb& rgb) {
  return {(rgb[2] - rgb[1]) / std::numbers::sqrt3, (rgb[0] - rgb[2]) / std::numbers::sqrt3,
          (rgb[1] - rgb[0]) / std::numbers::sqrt3};
}

Rgb times_logarithm(Rgb rgb) {
  for (Lanes& lanes : rgb)
    for (std::size_t i = 0; i < kLanes; ++i) lanes[i] = lanes[i] > 0 ? lanes[i] * std::log(lanes[i]) : 0;
  return rgb;
}

double sign(bool is_odd) { return is_odd ? -1.0 : 1.0; }

Lanes or_zero(Lanes value) { return value > 0.0 ? value : all(0); }

constexpr auto kPercent = AmplitudeUnit::Percent;
constexpr auto kPixels = AmplitudeUnit::Pixels;
constexpr auto kDegrees = AmplitudeUnit::Degrees;  // the amplitude is in radians
// Antialiasing on a grid, and a filter that reaches as far as half a pixel and no farther only nearly, move
// and soften edges by a few hundredths of a pixel.
constexpr double kNegligibleShift_px = 0.05;
constexpr double kNegligibleShare = 2e-3;
// 0.6 of 2 % (of 64 px, and of saturation), of one degree, and of half a pixel.
constexpr double kMostLight = 0.012;
constexpr double kMostHue = 0.6 * std::numbers::pi / 180;
constexpr double kMostShift_px = 0.3;
constexpr double kAny = std::numeric_limits<double>::infinity();  // the pattern is exact
// Differences of neighbours tell how an edge moves by as much as they are apart.
constexpr double kLargestShift_px = 1;
// What moves a corner 128 px from the middle by a few pixels.
constexpr double kLargestScale = 0.03;
constexpr double kLargestTurn = 0.35;     // of hue: the sine is its argument to 2 %
constexpr double kLargestExponent = 0.3;  // x^(1 + a) is x + a x log x to a tenth, for x of 1/4 to 4

constexpr std::array kRows{
    Row{{"brighter towards the right edge and darker towards the left",
         "brighter towards the left edge and darker towards the right", kPercent, kNegligibleShare,
         kMostLight},
        [](const Site& s) { return scaled(s.ring, s.x); }},
    Row{{"brighter towards the lower edge and darker towards the upper",
         "brighter towards the upper edge and darker towards the lower", kPercent, kNegligibleShare,
         kMostLight},
        [](const Site& s) { return scaled(s.ring, s.y); }},
    Row{{"brighter towards the corners", "darker towards the corners", kPercent, kNegligibleShare,
         kMostLight},
        [](const Site& s) { return scaled(s.ring, 0.75 * (s.x * s.x + s.y * s.y - 2.0 / 3)); }},
    Row{{"of more contrast", "of less contrast", kPercent, kNegligibleShare, kMostLight},
        [](const Site& s) { return minus(s.ring, all(1)); }},
    Row{{"brighter in its shadows", "darker in its shadows", kPercent, 2 * kNegligibleShare, 2 * kMostLight,
         0, kAny, "darker in its shadows, where most of the light is missing"},
        [](const Site& s) { return scaled(s.ring, or_zero(1 - 2 * s.luminance)); }},
    Row{{"brighter in its highlights", "darker in its highlights", kPercent, 2 * kNegligibleShare,
         2 * kMostLight, 0, kAny, "of negative light in its highlights"},
        [](const Site& s) { return scaled(s.ring, s.luminance > 2.0 ? all(1) : all(0)); }},
    Row{{"lifted in its black level", "lowered in its black level", kPercent, kNegligibleShare,
         kMostLight / 2, 0, kAny, "of negative light"},
        [](const Site&) {
          return Rgb{all(1), all(1), all(1)};
        }},
    Row{{"of more saturated colours", "of less saturated colours", kPercent, 2 * kNegligibleShare,
         kMostLight},
        [](const Site& s) { return minus(s.ring, s.luminance); },
        true},
    Row{{"turned in hue from red towards green", "turned in hue from green towards red", kDegrees,
         2 * kNegligibleShare, kMostHue, 0, kLargestTurn},
        [](const Site& s) { return turned_in_hue(s.ring); },
        true},
    Row{{"shifted to the left", "shifted to the right", kPixels, kNegligibleShift_px, kMostShift_px, 0,
         kLargestShift_px},
        [](const Site& s) { return s.slope_x; }},
    Row{{"shifted up", "shifted down", kPixels, kNegligibleShift_px, kMostShift_px, 0, kLargestShift_px},
        [](const Site& s) { return s.slope_y; }},
    Row{{"scaled down about its middle", "scaled up about its middle", kPercent, kNegligibleShare / 10, 0,
         kMostShift_px, kLargestScale},
        [](const Site& s) { return sum_of(s.slope_x, s.from_centre_x, s.slope_y, s.from_centre_y); }},
    Row{{"rotated clockwise about its middle", "rotated anticlockwise about its middle", kDegrees,
         kNegligibleShare / 10, 0, kMostShift_px, kLargestScale},
        [](const Site& s) { return sum_of(s.slope_x, s.from_centre_y, s.slope_y, -s.from_centre_x); }},
    Row{{"softer", "sharper", kPercent, 0.05, 0.3}, [](const Site& s) { return s.bend; }},
    Row{{"of a higher gamma", "of a lower gamma", kPercent, kNegligibleShare, kMostLight, 0,
         kLargestExponent},
        [](const Site& s) { return times_logarithm(s.ring); }},
    Row{{"striped: every second column is brighter", "striped: every second column is brighter", kPercent,
         kNegligibleShare, kMostLight},
        [](const Site& s) { return scaled(s.ring, s.sign_of_column); }},
    Row{{"striped: every second row is brighter", "striped: every second row is brighter", kPercent,
         kNegligibleShare, kMostLight},
        [](const Site& s) { return scaled(s.ring, s.sign_of_row); }},
    Row{{"chequered: every second pixel is brighter", "chequered: every second pixel is brighter", kPercent,
         kNegligibleShare, kMostLight},
        [](const Site& s) { return scaled(s.ring, s.sign_of_column * s.sign_of_row); }},
};

// As image::luminance.
Lanes luminance_of(const Rgb& rgb) { return 0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2]; }

Lanes dot(const Rgb& a, const Rgb& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

// Mean luminance of the counted pixels of the reference.
double mean_luminance(const PairSamples& samples) {
  double sum = 0;
  for (std::size_t pixel = 0; pixel < samples.included.size(); ++pixel) {
    if (samples.included[pixel] == 0) continue;
    const float* rgb = &samples.reference[3 * pixel];
    sum += image::luminance(static_cast<double>(rgb[0]), static_cast<double>(rgb[1]),
                            static_cast<double>(rgb[2]));
  }
  return sum / static_cast<double>(samples.included_count);
}

// A channel of an image over a mean, by rows. Four pixels can be read from each of its pixels on.
using Plane = std::vector<double>;

struct Planes {
  std::array<Plane, 3> reference;
  std::array<Plane, 3> difference;
};

Planes planes_of(const PairSamples& samples, double mean) {
  Planes planes;
  for (std::size_t c = 0; c < 3; ++c) {
    planes.reference.at(c).resize(samples.pixel_count() + kLanes);
    planes.difference.at(c).resize(samples.pixel_count() + kLanes);
    for (std::size_t pixel = 0; pixel < samples.pixel_count(); ++pixel) {
      const std::size_t i = 3 * pixel + c;
      planes.reference.at(c)[pixel] = static_cast<double>(samples.reference[i]) / mean;
      planes.difference.at(c)[pixel] = samples.difference(i) / mean;
    }
  }
  return planes;
}

Lanes lanes_at(const double* from) {
  Lanes lanes;
  std::memcpy(&lanes, from, sizeof lanes);
  return lanes;
}

// What the reference is around four pixels, the first of which is `at`.
void look_around(const double* at, std::ptrdiff_t width, std::size_t channel, Site& site) {
  Lanes inner{};
  Lanes outer{};
  for (std::ptrdiff_t v = -2; v <= 2; ++v)
    for (std::ptrdiff_t u = -2; u <= 2; ++u) {
      if (u == 0 && v == 0) continue;
      const bool is_inner = std::abs(u) <= 1 && std::abs(v) <= 1;
      (is_inner ? inner : outer) += lanes_at(at + v * width + u);
    }
  site.ring.at(channel) = inner / 8;
  site.bend.at(channel) = outer / 16 - inner / 8;
  site.slope_x.at(channel) = (lanes_at(at + 1) - lanes_at(at - 1)) / 2;
  site.slope_y.at(channel) = (lanes_at(at + width) - lanes_at(at - width)) / 2;
}

// Of the pixels from (x, y) on, which is two pixels from the edge at least.
Site site_at(const PairSamples& samples, const Planes& planes, int x, int y) {
  Site site;
  for (std::size_t c = 0; c < 3; ++c)
    look_around(&planes.reference.at(c)[samples.pixel_at(x, y)], samples.width, c, site);
  site.luminance = luminance_of(site.ring);
  for (int i = 0; i < kLanes; ++i) {
    const auto lane = static_cast<std::size_t>(i);
    site.from_centre_x[lane] = x + i + 0.5 - samples.width / 2.0;
    site.sign_of_column[lane] = sign((x + i) % 2 != 0);
  }
  site.from_centre_y = all(y + 0.5 - samples.height / 2.0);
  site.sign_of_row = all(sign(y % 2 != 0));
  site.x = site.from_centre_x / (samples.width / 2.0);
  site.y = site.from_centre_y / (samples.height / 2.0);
  return site;
}

// The difference less what is a factor of the light.
Rgb without_light(const Rgb& difference, const Site& site) {
  const Rgb rest = sum_of(difference, all(1), site.ring, -luminance_of(difference) / site.luminance);
  const auto choose = [&](std::size_t c) { return site.luminance > 0.0 ? rest.at(c) : difference.at(c); };
  return {choose(0), choose(1), choose(2)};
}

// Weighted, for the amplitude of each pattern.
using AllSums = std::array<AmplitudeSums, kRows.size()>;

// Of four pixels.
struct Projection {
  Lanes product{}, norm{};
};
using AllProjections = std::array<Projection, kRows.size()>;

// The index is known when this is compiled, so that each pattern's arithmetic stands here and is not called.
template <std::size_t... Index>
AllProjections projections_of(const Site& site,
                              const Rgb& difference,
                              std::index_sequence<Index...> /*all*/) {
  constexpr double kFloor = 0.1;  // of the mean: where it is darker, the noise no longer falls with the light
  const Lanes scale = or_zero(site.luminance) + kFloor;
  const Lanes weight = 1 / (scale * scale);  // the noise of a path tracer is nearly relative
  const Rgb of_colour = without_light(difference, site);
  const auto projection = [&](const Row& row) {
    const Rgb pattern = row.at(site);
    return Projection{weight * dot(pattern, row.is_of_colour ? of_colour : difference),
                      weight * dot(pattern, pattern)};
  };
  return {projection(kRows[Index])...};
}

// Of `count` pixels from (x, y) on, each where it counts.
void add_pixels(const PairSamples& samples, const Planes& planes, int x, int y, int count, AllSums& sums) {
  const std::size_t pixel = samples.pixel_at(x, y);
  const Rgb difference{lanes_at(&planes.difference[0][pixel]), lanes_at(&planes.difference[1][pixel]),
                       lanes_at(&planes.difference[2][pixel])};
  const auto projections =
      projections_of(site_at(samples, planes, x, y), difference, std::make_index_sequence<kRows.size()>());
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
    if (samples.included[pixel + i] == 0) continue;
    for (std::size_t row = 0; row < kRows.size(); ++row) {
      sums[row].product += projections[row].product[i];
      sums[row].norm += projections[row].norm[i];
    }
  }
}

AllSums sums_of_block(const PairSamples& samples, const Planes& planes, const Rectangle& block) {
  AllSums sums{};
  const int end = std::min(block.x1, samples.width - 2);
  for (int y = std::max(block.y0, 2); y < std::min(block.y1, samples.height - 2); ++y)
    for (int x = std::max(block.x0, 2); x < end; x += kLanes)
      add_pixels(samples, planes, x, y, std::min(kLanes, end - x), sums);
  return sums;
}

Amplitude amplitude_of_row(const std::vector<AllSums>& blocks, std::size_t row) {
  std::vector<AmplitudeSums> sums;
  sums.reserve(blocks.size());
  for (const auto& block : blocks) sums.push_back(block.at(row));
  return amplitude_of(sums);
}

double most_of(const Pattern& pattern, const PairSamples& samples) {
  return pattern.most > 0 ? pattern.most
                          : pattern.most_at_edge_px * 2 / std::max(samples.width, samples.height);
}

std::optional<PatternFinding> finding_of(const Row& row,
                                         const Amplitude& amplitude,
                                         double probability,
                                         const PairSamples& samples) {
  if (!(amplitude.of_noise.sum > 0) || !(amplitude.norm > 0)) return std::nullopt;
  const double value = amplitude.value();
  if (std::fabs(value) - amplitude.reach(amplitude.of_noise, probability) <= row.pattern.negligible)
    return std::nullopt;
  const double reach = amplitude.reach(amplitude.of_remainder, probability);
  const double certain = std::max(0.0, std::fabs(value) - reach);
  return PatternFinding{.pattern = &row.pattern,
                        .amplitude = value,
                        .low = value - reach,
                        .high = value + reach,
                        .z = std::fabs(amplitude.product) / std::sqrt(amplitude.of_noise.sum),
                        .excess = certain / most_of(row.pattern, samples)};
}

// The blocks' scatter tells a shift only where many of them have edges. What is told by the edges alone
// counts where it is larger for certain.
void add_edge_shift(const PairSamples& samples, double probability, std::vector<PatternFinding>& findings) {
  constexpr std::array kNames{"shifted to the left", "shifted up"};
  const auto told = edge_shift(samples, probability);
  for (std::size_t axis = 0; axis < kNames.size(); ++axis) {
    const auto& shift = told.px.at(axis);
    const double certain = std::fabs(shift.value) - (shift.high - shift.value);
    const auto& row = *std::find_if(kRows.begin(), kRows.end(),
                                    [&](const Row& one) { return one.pattern.more == kNames.at(axis); });
    if (certain <= row.pattern.negligible) continue;
    const PatternFinding finding{.pattern = &row.pattern,
                                 .amplitude = shift.value,
                                 .low = shift.low,
                                 .high = shift.high,
                                 .z = told.z.at(axis),
                                 .excess = certain / most_of(row.pattern, samples)};
    const auto known = std::find_if(findings.begin(), findings.end(),
                                    [&](const auto& one) { return one.pattern == &row.pattern; });
    if (known == findings.end())
      findings.push_back(finding);
    else if (known->excess < finding.excess)
      *known = finding;
  }
}

}  // namespace

std::vector<PatternFinding> find_patterns(const PairSamples& samples, double false_alarms) {
  const double mean = mean_luminance(samples);
  if (!(mean > 0)) return {};  // black, or a difference of images, which has no mean level
  const auto planes = planes_of(samples, mean);
  std::vector<AllSums> blocks;
  for (const Rectangle& block : blocks_of(samples)) blocks.push_back(sums_of_block(samples, planes, block));
  std::vector<PatternFinding> findings;
  for (std::size_t i = 0; i < kRows.size(); ++i)
    if (const auto finding =
            finding_of(kRows.at(i), amplitude_of_row(blocks, i), false_alarms / kRows.size(), samples))
      findings.push_back(*finding);
  add_edge_shift(samples, false_alarms / kRows.size(), findings);
  std::stable_sort(findings.begin(), findings.end(), [](const auto& a, const auto& b) { return a.z > b.z; });
  return findings;
}

bool is_within_range(const PatternFinding& finding) {
  return std::max(std::fabs(finding.low), std::fabs(finding.high)) <= finding.pattern->largest;
}

std::string describe(const PatternFinding& finding) {
  struct Unit {
    const char* name;
    double scale;
  };
  constexpr std::array<Unit, 3> kUnits{{{"%", 100}, {"px", 1}, {"degrees", 180 / std::numbers::pi}}};
  const bool can_be_all = !finding.pattern->beyond_all.empty() && finding.amplitude < 0;
  if (can_be_all && finding.amplitude < -1) return std::string(finding.pattern->beyond_all);
  const auto& [name, scale] = kUnits.at(static_cast<std::size_t>(finding.pattern->unit));
  // Towards the side that is named; the interval can reach to the other one.
  const double side = finding.amplitude > 0 ? scale : -scale;
  const auto [low, high] = std::minmax({side * finding.low, side * finding.high});
  return fmt::format("{} by {:.3g} {} ({:.3g} to {:.3g})",
                     finding.amplitude > 0 ? finding.pattern->more : finding.pattern->less,
                     side * finding.amplitude, name, low, can_be_all ? std::min(high, scale) : high);
}

}  // namespace orbs::metrics
