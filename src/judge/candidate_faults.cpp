#include "judge/candidate_faults.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <set>
#include <utility>
#include <vector>

namespace orbs::judge {

namespace {

using image::Image;

// The colours alone, and what all candidates need of them.
struct Search {
  const FaultSubject& subject;
  Image result;
  Image reference;
  std::vector<std::uint8_t> included;
  const std::function<void(CandidateFault&&)>& visit;

  Rectangle all() const { return {0, 0, reference.width, reference.height}; }

  // The fault put upon `reference`, of which the colours count.
  template <typename Kind>
  CandidateFault candidate(const Kind& fault, const Image& reference_with_layers) const {
    return {fault, fault.text(), image::select_rgb(fault.apply(reference_with_layers), ""), all()};
  }
  template <typename Kind>
  void add(const Kind& fault) const {
    visit(candidate(fault, reference));
  }
  template <typename Kind>
  void add_undone(const Kind& fault) const {
    auto one = candidate(fault, reference);
    one.undone = fault.undo(result);
    visit(std::move(one));
  }
  template <typename Kind>
  void add_averaging(const Kind& fault) const {
    auto one = candidate(fault, reference);
    one.averages_noise = true;
    visit(std::move(one));
  }
};

std::size_t pixel_at(const Image& image, int x, int y) {
  return static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x);
}

// Sums of products over the counted pixels, each pixel divided by the light there: a highlight counts no more
// than what it lights.
struct Products {
  double rf = 0, ff = 0, r = 0, f = 0, one = 0;
};

Products products_of(const Search& search) {
  Products sums;
  for (std::size_t pixel = 0; pixel < search.included.size(); ++pixel) {
    if (search.included[pixel] == 0) continue;
    for (std::size_t i = 3 * pixel; i < 3 * pixel + 3; ++i) {
      const auto r = static_cast<double>(search.result.pixels[i]);
      const auto f = static_cast<double>(search.reference.pixels[i]);
      const double weight = 1 / (std::fabs(r) + std::fabs(f) + 1e-6);
      sums.rf += weight * r * f;
      sums.ff += weight * f * f;
      sums.r += r;
      sums.f += f;
      sums.one += 1;
    }
  }
  return sums;
}

constexpr int kFarthestShift_px = 8;

// Mean squared difference of result and shifted reference over a part of the pixels that all shifts know.
double coarse_error(const Search& search, int dx, int dy) {
  constexpr int kStep_px = 2;
  const auto& [width, height] = std::pair(search.result.width, search.result.height);
  const int margin = std::min({kFarthestShift_px, (width - 1) / 4, (height - 1) / 4});
  double sum = 0;
  for (int y = margin; y < height - margin; y += kStep_px)
    for (int x = margin; x < width - margin; x += kStep_px) {
      if (search.included[pixel_at(search.result, x, y)] == 0) continue;
      for (std::size_t c = 0; c < 3; ++c) {
        const float r = search.result.at(x, y, c);
        const float f = search.reference.at(x - dx, y - dy, c);
        const auto d = static_cast<double>((r - f) / (std::fabs(r) + std::fabs(f) + 0.01F));
        sum += d * d;
      }
    }
  return sum;
}

std::pair<int, int> nearest_shift(const Search& search) {
  const int most =
      std::min({kFarthestShift_px, (search.result.width - 1) / 4, (search.result.height - 1) / 4});
  std::pair<int, int> nearest{0, 0};
  double least = coarse_error(search, 0, 0);
  for (int dy = -most; dy <= most; ++dy)
    for (int dx = -most; dx <= most; ++dx)
      if (const double error = coarse_error(search, dx, dy); error < least) {
        least = error;
        nearest = {dx, dy};
      }
  return nearest;
}

// The pixels of a moved image that come from within the original.
Rectangle known_after(const Image& image, double dx, double dy) {
  const auto begin = [](double by) { return std::max(0, static_cast<int>(std::ceil(by))); };
  const auto end = [](int size, double by) {
    return std::min(size, static_cast<int>(std::floor(size + by)));
  };
  return {begin(dx), begin(dy), end(image.width, dx), end(image.height, dy)};
}

void add_shifts(const Search& search) {
  const auto [whole_x, whole_y] = nearest_shift(search);
  for (const double half_x : {0.0, 0.5, -0.5})
    for (const double half_y : {0.0, 0.5, -0.5}) {
      const double dx = whole_x + half_x;
      const double dy = whole_y + half_y;
      if (dx == 0 && dy == 0) continue;
      const bool is_whole = half_x == 0 && half_y == 0;
      for (const auto between : {faults::Between::Linear, faults::Between::Cubic}) {
        if (is_whole && between == faults::Between::Cubic) continue;
        auto one = search.candidate(faults::Shift{dx, dy, between}, search.reference);
        one.known = known_after(search.reference, dx, dy);
        one.averages_noise = !is_whole;
        search.visit(std::move(one));
      }
    }
}

void add_turns(const Search& search) {
  const std::vector<faults::Turn> turns{{.mirrors_x = true},
                                        {.mirrors_y = true},
                                        {.mirrors_x = true, .mirrors_y = true},
                                        {.mirrors_y = true, .exchanges = true},
                                        {.mirrors_x = true, .exchanges = true},
                                        {.exchanges = true},
                                        {.mirrors_x = true, .mirrors_y = true, .exchanges = true}};
  for (const auto& turn : turns)
    if (!turn.exchanges || search.reference.width == search.reference.height) search.add(turn);
}

void add_channels(const Search& search) {
  for (const auto& from :
       std::vector<std::array<std::size_t, 3>>{{2, 1, 0}, {1, 0, 2}, {0, 2, 1}, {1, 2, 0}, {2, 0, 1}})
    search.add(faults::ChannelOrder{from});
}

double brightness(const Image& image, std::size_t pixel) {
  const float* rgb = &image.pixels[3 * pixel];
  return static_cast<double>(rgb[0]) + static_cast<double>(rgb[1]) + static_cast<double>(rgb[2]);
}

// 1 where the result is not black.
std::vector<std::uint8_t> lit_pixels(const Image& result) {
  std::vector<std::uint8_t> lit(result.pixel_count());
  for (std::size_t pixel = 0; pixel < lit.size(); ++pixel)
    lit[pixel] = result.pixels[3 * pixel] != 0 || result.pixels[3 * pixel + 1] != 0 ||
                         result.pixels[3 * pixel + 2] != 0
                     ? 1
                     : 0;
  return lit;
}

// Whether more than half of the light of the reference is exactly black in the result. No factor, constant or
// curve does that; a small factor only comes near.
bool is_mostly_black(const Search& search) {
  const auto lit = lit_pixels(search.result);
  std::size_t light = 0;
  std::size_t black = 0;
  for (std::size_t pixel = 0; pixel < lit.size(); ++pixel) {
    if (search.included[pixel] == 0 || !(brightness(search.reference, pixel) > 0)) continue;
    ++light;
    if (lit[pixel] == 0) ++black;
  }
  return 2 * black > light;
}

void add_factor_and_offset(const Search& search) {
  const auto sums = products_of(search);
  if (sums.ff > 0 && sums.rf > 0) search.add_undone(faults::Factor{sums.rf / sums.ff});
  if (sums.one > 0) search.add_undone(faults::Offset{(sums.r - sums.f) / sums.one});
}

void add_curves(const Search& search) {
  using Kind = faults::Curve::Kind;
  for (const auto kind : {Kind::SrgbEncoded, Kind::SrgbDecoded, Kind::Gamma22Encoded, Kind::Gamma22Decoded,
                          Kind::SrgbEncodedAndClamped})
    search.add_undone(faults::Curve{kind});
}

// A clamp leaves several samples at exactly the largest value; noise does not.
void add_clamp(const Search& search) {
  constexpr int kFewest = 4;
  float most = 0;
  int at_most = 0;
  for (std::size_t i = 0; i < search.result.pixels.size(); ++i) {
    if (search.included[i / 3] == 0 || search.result.pixels[i] < most) continue;
    at_most = search.result.pixels[i] == most ? at_most + 1 : 1;
    most = search.result.pixels[i];
  }
  if (at_most >= kFewest && most > 0) search.add(faults::Clamp{most});
}

void add_filters(const Search& search) {
  for (const double sigma_px : {0.3, 0.4, 0.5, 0.6, 0.7, 0.85, 1.0, 1.2, 1.5, 2.0, 2.5, 3.0})
    search.add_averaging(faults::Blur{sigma_px});
  for (const double side_px : {3, 5, 7})
    search.add_averaging(faults::Blur{side_px, faults::Blur::Filter::Box});
  for (const int side_px : {2, 3, 4, 8}) search.add_averaging(faults::Resolution{side_px});
}

void add_magnifications(const Search& search) {
  for (int percent = -50; percent <= 100; percent += percent < 50 && percent > -50 ? 5 : 10)
    if (percent != 0) search.add_averaging(faults::Magnification{1 + percent / 100.0});
}

// Emitters are what is brightest: half of what is lit is brighter in the reference than all but a hundredth
// of the rest. Their edges are darker, and some highlights brighter.
bool are_emitters(const Search& search, const std::vector<std::uint8_t>& lit) {
  std::vector<double> shown;
  std::vector<double> missing;
  for (std::size_t pixel = 0; pixel < lit.size(); ++pixel)
    if (search.included[pixel] != 0)
      (lit[pixel] != 0 ? shown : missing).push_back(brightness(search.reference, pixel));
  if (shown.empty() || missing.empty()) return false;
  const auto quantile = [](std::vector<double>& values, std::size_t at) {
    const auto place = values.begin() + static_cast<std::ptrdiff_t>(at);
    std::nth_element(values.begin(), place, values.end());
    return *place;
  };
  return quantile(shown, shown.size() / 2) > quantile(missing, missing.size() - 1 - missing.size() / 100);
}

// Beside black, an image without reflected light looks cropped to its lamp. A crop cuts through what it
// shows.
void add_crop_or_emitters(const Search& search) {
  const Image& result = search.result;
  auto lit_pixel = lit_pixels(result);
  if (is_mostly_black(search) && are_emitters(search, lit_pixel)) {
    search.add(faults::EmittersOnly{std::move(lit_pixel)});
    return;
  }
  Rectangle lit{result.width, result.height, 0, 0};
  for (int y = 0; y < result.height; ++y)
    for (int x = 0; x < result.width; ++x)
      if (lit_pixel[pixel_at(result, x, y)] != 0)
        lit = {std::min(lit.x0, x), std::min(lit.y0, y), std::max(lit.x1, x + 1), std::max(lit.y1, y + 1)};
  if (lit.x1 <= lit.x0 || (lit.x1 - lit.x0 == result.width && lit.y1 - lit.y0 == result.height)) return;
  search.add(faults::Crop{lit});
}

void add_alpha(const Search& search) {
  const auto& result = search.subject.result;
  const int channel = image::channel_index(result, "A");
  if (channel < 0) return;
  faults::Alpha fault;
  for (std::size_t i = 0; i < result.pixels.size(); i += result.channel_count())
    fault.alpha.push_back(result.pixels[i + static_cast<std::size_t>(channel)]);
  for (const auto kind : {faults::Alpha::Kind::Multiplied, faults::Alpha::Kind::Divided}) {
    fault.kind = kind;
    search.add(fault);
  }
}

// Classes are words of Heckbert's letters from the eye: "EDL" is light that one diffuse surface sends to it.
bool is_direct(const std::string& path_class) { return path_class.size() <= 3; }

void add_light_paths(const Search& search) {
  std::set<std::string> classes;
  for (const auto& channel : search.subject.reference.channels)
    if (channel.starts_with("path.") && channel.ends_with(".R"))
      classes.insert(channel.substr(5, channel.size() - 7));
  faults::LightPaths indirect{{}, true};
  for (const auto& one : classes) {
    search.visit(search.candidate(faults::LightPaths{{one}}, search.subject.reference));
    if (!is_direct(one)) indirect.missing.push_back(one);
  }
  if (std::any_of(classes.begin(), classes.end(), is_direct))
    search.visit(search.candidate(indirect, search.subject.reference));
}

// Emitters are what is brightest in the reference; the fault leaves them as they are. Where none is seen, all
// is doubled, which is a factor.
void add_no_mis_weight(const Search& search) {
  constexpr double kBright = 0.5;  // of the brightest
  constexpr double kNear = 0.3;    // of the reference: far from twice of it
  constexpr double kMostAre = 0.8;
  double most = 0;
  for (std::size_t pixel = 0; pixel < search.included.size(); ++pixel)
    if (search.included[pixel] != 0) most = std::max(most, brightness(search.reference, pixel));
  faults::NoMisWeight fault{std::vector<std::uint8_t>(search.included.size())};
  int bright = 0;
  int right = 0;
  for (std::size_t pixel = 0; pixel < search.included.size(); ++pixel) {
    const double wanted = brightness(search.reference, pixel);
    if (search.included[pixel] == 0 || wanted < kBright * most) continue;
    ++bright;
    if (std::fabs(brightness(search.result, pixel) - wanted) > kNear * wanted) continue;
    ++right;
    fault.emitters[pixel] = 1;
  }
  if (right > 0 && right >= kMostAre * bright) search.add(fault);
}

void add_other_targets(const Search& search) {
  for (const auto& [name, other] : search.subject.other_targets)
    if (other.width == search.result.width && other.height == search.result.height)
      search.add(faults::OtherImage{name, &other});
}

}  // namespace

void for_each_candidate(const FaultSubject& subject, const std::function<void(CandidateFault&&)>& visit) {
  const Search search{
      subject, image::select_rgb(subject.result, ""), image::select_rgb(subject.reference, ""),
      metrics::included_pixels(subject.mask, subject.result.width, subject.result.height), visit};
  add_shifts(search);
  add_turns(search);
  add_channels(search);
  if (!is_mostly_black(search)) {
    add_factor_and_offset(search);
    add_curves(search);
  }
  add_clamp(search);
  add_filters(search);
  add_magnifications(search);
  add_crop_or_emitters(search);
  add_alpha(search);
  add_light_paths(search);
  add_no_mis_weight(search);
  add_other_targets(search);
}

}  // namespace orbs::judge
