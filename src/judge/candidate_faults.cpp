#include "judge/candidate_faults.h"

#include "image/colour.h"
#include "judge/fault_images.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <set>
#include <utility>
#include <vector>

#include <fmt/format.h>

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
  void add(FaultKind kind, std::string text, Image like) const {
    visit({kind, std::move(text), std::move(like), all()});
  }
  void add_undone(FaultKind kind, std::string text, Image like, Image undone) const {
    visit({kind, std::move(text), std::move(like), all(), false, std::move(undone)});
  }
  void add_averaging(FaultKind kind, std::string text, Image like) const {
    visit({kind, std::move(text), std::move(like), all(), true});
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
      for (const auto between : {Between::Linear, Between::Cubic}) {
        if (is_whole && between == Between::Cubic) continue;
        search.visit({FaultKind::Shift, fmt::format("shifted by ({}, {}) px", dx, dy),
                      moved_by(search.reference, dx, dy, between), known_after(search.reference, dx, dy),
                      !is_whole});
      }
    }
}

void add_orientations(const Search& search) {
  const int right = search.reference.width - 1;
  const int bottom = search.reference.height - 1;
  struct Turn {
    const char* text;
    std::function<std::array<int, 2>(int, int)> from;
    bool is_square_only;
  };
  const std::vector<Turn> turns{{"mirrored left to right",
                                 [=](int x, int y) {
                                   return std::array{right - x, y};
                                 },
                                 false},
                                {"upside down",
                                 [=](int x, int y) {
                                   return std::array{x, bottom - y};
                                 },
                                 false},
                                {"turned by 180 degrees",
                                 [=](int x, int y) {
                                   return std::array{right - x, bottom - y};
                                 },
                                 false},
                                {"turned by 90 degrees to the right",
                                 [=](int x, int y) {
                                   return std::array{y, bottom - x};
                                 },
                                 true},
                                {"turned by 90 degrees to the left",
                                 [=](int x, int y) {
                                   return std::array{right - y, x};
                                 },
                                 true},
                                {"transposed (x and y exchanged)",
                                 [=](int x, int y) {
                                   return std::array{y, x};
                                 },
                                 true},
                                {"transposed and turned by 180 degrees",
                                 [=](int x, int y) {
                                   return std::array{right - y, bottom - x};
                                 },
                                 true}};
  for (const auto& [text, from, is_square_only] : turns)
    if (!is_square_only || right == bottom)
      search.add(FaultKind::Orientation, text, rearranged(search.reference, from));
}

void add_channels(const Search& search) {
  struct Order {
    const char* text;
    std::array<std::size_t, 3> from;
  };
  constexpr std::array<Order, 5> kOrders{{{"with R and B swapped", {2, 1, 0}},
                                          {"with R and G swapped", {1, 0, 2}},
                                          {"with G and B swapped", {0, 2, 1}},
                                          {"with R, G, B in the order G, B, R", {1, 2, 0}},
                                          {"with R, G, B in the order B, R, G", {2, 0, 1}}}};
  for (const auto& [text, from] : kOrders) {
    Image like = search.reference;
    for (std::size_t i = 0; i < like.pixels.size(); i += 3)
      for (std::size_t c = 0; c < 3; ++c) like.pixels[i + c] = search.reference.pixels[i + from.at(c)];
    search.add(FaultKind::Channels, text, std::move(like));
  }
}

// Radiance and exitance differ by pi, and halves, quarters and powers of ten are what is forgotten most.
std::string factor_text(double factor) {
  constexpr double kPi = std::numbers::pi;
  struct Named {
    const char* name;
    double value;
  };
  constexpr std::array<Named, 12> kNamed{{{"pi", kPi},
                                          {"1/pi", 1 / kPi},
                                          {"2 pi", 2 * kPi},
                                          {"1/(2 pi)", 1 / (2 * kPi)},
                                          {"4 pi", 4 * kPi},
                                          {"1/(4 pi)", 1 / (4 * kPi)},
                                          {"2", 2},
                                          {"1/2", 0.5},
                                          {"4", 4},
                                          {"1/4", 0.25},
                                          {"10", 10},
                                          {"1/10", 0.1}}};
  constexpr double kNear = 0.01;
  for (const auto& [name, value] : kNamed)
    if (std::fabs(factor / value - 1) < kNear) return fmt::format("multiplied by {}", name);
  return fmt::format("multiplied by {:.4g}", factor);
}

void add_factor_and_offset(const Search& search) {
  const auto sums = products_of(search);
  if (sums.ff > 0 && sums.rf > 0) {
    const double factor = sums.rf / sums.ff;
    const auto k = static_cast<float>(factor);
    search.add_undone(FaultKind::Factor, factor_text(factor),
                      mapped(search.reference, [k](float value) { return k * value; }),
                      mapped(search.result, [k](float value) { return value / k; }));
  }
  if (sums.one > 0) {
    const double offset = (sums.r - sums.f) / sums.one;
    const auto b = static_cast<float>(offset);
    search.add_undone(FaultKind::Offset, fmt::format("off by {:+.3g} in every pixel", offset),
                      mapped(search.reference, [b](float value) { return value + b; }),
                      mapped(search.result, [b](float value) { return value - b; }));
  }
}

float power(float value, float exponent) {
  return std::copysign(std::pow(std::fabs(value), exponent), value);
}

void add_gammas(const Search& search) {
  constexpr float kGamma = 2.2F;
  const auto add = [&](const char* text, const std::function<float(float)>& fault,
                       const std::function<float(float)>& inverse) {
    search.add_undone(FaultKind::Gamma, text, mapped(search.reference, fault),
                      mapped(search.result, inverse));
  };
  const auto raised = [](float value) { return power(value, kGamma); };
  const auto rooted = [](float value) { return power(value, 1 / kGamma); };
  add("encoded for the screen (sRGB), not linear", image::srgb_encode, image::srgb_decode);
  add("decoded from sRGB though it was linear", image::srgb_decode, image::srgb_encode);
  add("encoded for the screen (gamma 2.2), not linear", rooted, raised);
  add("decoded from gamma 2.2 though it was linear", raised, rooted);
  search.add(FaultKind::Gamma, "encoded for the screen (sRGB) and clamped to 1, not linear",
             mapped(search.reference,
                    [](float value) { return image::srgb_encode(std::clamp(value, 0.0F, 1.0F)); }));
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
  if (at_most < kFewest || most <= 0) return;
  search.add(FaultKind::Clamp, fmt::format("clamped at {:.4g}", most),
             mapped(search.reference, [most](float value) { return std::min(value, most); }));
}

void add_blurs(const Search& search) {
  constexpr double kWidthOfHalf = 2.3548;  // full width at half maximum of a Gaussian of deviation 1
  for (const double sigma_px : {0.3, 0.4, 0.5, 0.6, 0.7, 0.85, 1.0, 1.2, 1.5, 2.0, 2.5, 3.0})
    search.add_averaging(FaultKind::Blur,
                         fmt::format("blurred by a filter of {:.2g} px", kWidthOfHalf * sigma_px),
                         gaussian_blurred(search.reference, sigma_px));
  for (const int side_px : {3, 5, 7})
    search.add_averaging(FaultKind::Blur, fmt::format("blurred by a box filter of {} px", side_px),
                         box_blurred(search.reference, side_px));
}

void add_resolutions(const Search& search) {
  for (const int side_px : {2, 3, 4, 8})
    search.add_averaging(FaultKind::Resolution, fmt::format("of 1/{} of the resolution", side_px),
                         in_squares(search.reference, side_px));
}

void add_scales(const Search& search) {
  for (int percent = -50; percent <= 100; percent += percent < 50 && percent > -50 ? 5 : 10) {
    if (percent == 0) continue;
    const double factor = 1 + percent / 100.0;
    search.visit({FaultKind::Scale, fmt::format("magnified by {:.3g} about its centre", factor),
                  magnified(search.reference, factor), search.all(), true});
  }
}

void add_crop(const Search& search) {
  const Image& result = search.result;
  Rectangle lit{result.width, result.height, 0, 0};
  for (int y = 0; y < result.height; ++y)
    for (int x = 0; x < result.width; ++x)
      if (result.at(x, y, 0) != 0 || result.at(x, y, 1) != 0 || result.at(x, y, 2) != 0)
        lit = {std::min(lit.x0, x), std::min(lit.y0, y), std::max(lit.x1, x + 1), std::max(lit.y1, y + 1)};
  if (lit.x1 <= lit.x0 || (lit.x1 - lit.x0 == result.width && lit.y1 - lit.y0 == result.height)) return;
  Image like = search.reference;
  for (int y = 0; y < like.height; ++y)
    for (int x = 0; x < like.width; ++x)
      if (x < lit.x0 || x >= lit.x1 || y < lit.y0 || y >= lit.y1)
        for (std::size_t c = 0; c < 3; ++c) like.at(x, y, c) = 0;
  search.add(FaultKind::Crop, fmt::format("cropped to the pixels {}, black beside them", rectangle_text(lit)),
             std::move(like));
}

void add_alpha(const Search& search) {
  const int alpha = image::channel_index(search.subject.result, "A");
  if (alpha < 0) return;
  const auto alpha_of = [&](std::size_t pixel) {
    return search.subject.result
        .pixels[pixel * search.subject.result.channel_count() + static_cast<std::size_t>(alpha)];
  };
  Image multiplied = search.reference;
  Image divided = search.reference;
  for (std::size_t pixel = 0; pixel < multiplied.pixel_count(); ++pixel)
    for (std::size_t i = 3 * pixel; i < 3 * pixel + 3; ++i) {
      multiplied.pixels[i] *= alpha_of(pixel);
      if (alpha_of(pixel) > 0) divided.pixels[i] /= alpha_of(pixel);
    }
  search.add(FaultKind::Alpha, "multiplied by its alpha once too often", std::move(multiplied));
  search.add(FaultKind::Alpha, "divided by its alpha once too often", std::move(divided));
}

// Classes are words of Heckbert's letters from the eye: "EDL" is light that one diffuse surface sends to it.
bool is_direct(const std::string& path_class) { return path_class.size() <= 3; }

void add_light_paths(const Search& search) {
  std::set<std::string> classes;
  for (const auto& channel : search.subject.reference.channels)
    if (channel.starts_with("path.") && channel.ends_with(".R"))
      classes.insert(channel.substr(5, channel.size() - 7));
  Image direct = search.reference;
  for (const auto& one : classes) {
    const auto layer = image::select_rgb(search.subject.reference, "path." + one + ".");
    Image like = search.reference;
    for (std::size_t i = 0; i < like.pixels.size(); ++i) {
      like.pixels[i] -= layer.pixels[i];
      if (!is_direct(one)) direct.pixels[i] -= layer.pixels[i];
    }
    search.add(FaultKind::LightPaths, fmt::format("without the light paths {}", one), std::move(like));
  }
  if (std::any_of(classes.begin(), classes.end(), is_direct))
    search.add(FaultKind::LightPaths, "direct light only", std::move(direct));
}

void add_other_targets(const Search& search) {
  for (const auto& [name, other] : search.subject.other_targets)
    if (other.width == search.result.width && other.height == search.result.height)
      search.add(FaultKind::OtherTarget, fmt::format("the image of '{}'", name),
                 image::select_rgb(other, ""));
}

}  // namespace

void for_each_candidate(const FaultSubject& subject, const std::function<void(CandidateFault&&)>& visit) {
  const Search search{
      subject, image::select_rgb(subject.result, ""), image::select_rgb(subject.reference, ""),
      metrics::included_pixels(subject.mask, subject.result.width, subject.result.height), visit};
  add_shifts(search);
  add_orientations(search);
  add_channels(search);
  add_factor_and_offset(search);
  add_gammas(search);
  add_clamp(search);
  add_blurs(search);
  add_resolutions(search);
  add_scales(search);
  add_crop(search);
  add_alpha(search);
  add_light_paths(search);
  add_other_targets(search);
}

}  // namespace orbs::judge
