#include "studies/qualify/subtle_faults.h"

#include "image/colour.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <utility>

#include <fmt/format.h>

namespace orbs::studies {

namespace {

using image::Image;
using Rgb = std::array<double, 3>;

std::array<std::size_t, 3> rgb_channels(const Image& image) {
  return {static_cast<std::size_t>(image::channel_index(image, "R")),
          static_cast<std::size_t>(image::channel_index(image, "G")),
          static_cast<std::size_t>(image::channel_index(image, "B"))};
}

Rgb rgb_at(const Image& image, const std::array<std::size_t, 3>& channels, int x, int y) {
  const int u = std::clamp(x, 0, image.width - 1);
  const int v = std::clamp(y, 0, image.height - 1);
  return {static_cast<double>(image.at(u, v, channels[0])), static_cast<double>(image.at(u, v, channels[1])),
          static_cast<double>(image.at(u, v, channels[2]))};
}

double luminance_of(const Rgb& rgb) { return image::luminance(rgb[0], rgb[1], rgb[2]); }

// The image with change(image before, x, y) as the colour of each pixel.
template <typename PixelChange>
Image with_each(const Image& image, PixelChange change) {
  Image out = image;
  const auto channels = rgb_channels(image);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const Rgb rgb = change(image, x, y, rgb_at(image, channels, x, y));
      for (std::size_t c = 0; c < 3; ++c) out.at(x, y, channels.at(c)) = static_cast<float>(rgb.at(c));
    }
  return out;
}

// factor(x, y) of the light of each pixel; x and y from -1 to 1.
Fault scaled_by(std::string name, std::function<double(double, double)> factor) {
  return {std::move(name), [factor = std::move(factor)](const Image& image) {
            return with_each(image, [&](const Image&, int x, int y, Rgb rgb) {
              const double f = factor((2 * x + 1.0) / image.width - 1, (2 * y + 1.0) / image.height - 1);
              return Rgb{f * rgb[0], f * rgb[1], f * rgb[2]};
            });
          }};
}

// map(value, its channel) of each value.
Fault mapped(std::string name, std::function<double(double, std::size_t)> map) {
  return {std::move(name), [map = std::move(map)](const Image& image) {
            return with_each(image, [&](const Image&, int, int, Rgb rgb) {
              return Rgb{map(rgb[0], 0), map(rgb[1], 1), map(rgb[2], 2)};
            });
          }};
}

Fault mixed_with_grey(std::string name, double share) {
  return {std::move(name), [share](const Image& image) {
            return with_each(image, [&](const Image&, int, int, Rgb rgb) {
              const double grey = luminance_of(rgb);
              for (double& value : rgb) value += share * (grey - value);
              return rgb;
            });
          }};
}

// Resampled at (x, y) - shift(x, y), bilinearly.
Fault moved(std::string name, std::function<std::array<double, 2>(double, double)> shift) {
  return {std::move(name), [shift = std::move(shift)](const Image& image) {
            const auto channels = rgb_channels(image);
            return with_each(image, [&](const Image& before, int x, int y, const Rgb&) {
              const auto by = shift(x + 0.5 - before.width / 2.0, y + 0.5 - before.height / 2.0);
              const double u = x - by[0];
              const double v = y - by[1];
              const int u0 = static_cast<int>(std::floor(u));
              const int v0 = static_cast<int>(std::floor(v));
              Rgb sum{};
              for (int dy = 0; dy < 2; ++dy)
                for (int dx = 0; dx < 2; ++dx) {
                  const double weight = (1 - std::fabs(u - u0 - dx)) * (1 - std::fabs(v - v0 - dy));
                  const Rgb rgb = rgb_at(before, channels, u0 + dx, v0 + dy);
                  for (std::size_t c = 0; c < 3; ++c) sum.at(c) += weight * rgb.at(c);
                }
              return sum;
            });
          }};
}

Rgb gaussian_at(const Image& image, const std::array<std::size_t, 3>& channels, int x, int y, double sigma) {
  const int reach = std::max(1, static_cast<int>(std::ceil(3 * sigma)));
  Rgb sum{};
  double weights = 0;
  for (int v = y - reach; v <= y + reach; ++v)
    for (int u = x - reach; u <= x + reach; ++u) {
      const double weight = std::exp(-((u - x) * (u - x) + (v - y) * (v - y)) / (2 * sigma * sigma));
      const Rgb rgb = rgb_at(image, channels, u, v);
      weights += weight;
      for (std::size_t c = 0; c < 3; ++c) sum.at(c) += weight * rgb.at(c);
    }
  for (double& value : sum) value /= weights;
  return sum;
}

// share: 1 blurs, -1 adds what the blur would take away.
Fault blurred(std::string name, double sigma_px, double share) {
  return {std::move(name), [=](const Image& image) {
            const auto channels = rgb_channels(image);
            return with_each(image, [&](const Image& before, int x, int y, Rgb rgb) {
              const Rgb soft = gaussian_at(before, channels, x, y, sigma_px);
              for (std::size_t c = 0; c < 3; ++c) rgb.at(c) += share * (soft.at(c) - rgb.at(c));
              return rgb;
            });
          }};
}

Fault median_filtered() {
  return {"median of 3 x 3 px", [](const Image& image) {
            const auto channels = rgb_channels(image);
            return with_each(image, [&](const Image& before, int x, int y, const Rgb&) {
              Rgb middle{};
              for (std::size_t c = 0; c < 3; ++c) {
                std::array<double, 9> values{};
                for (int i = 0; i < 9; ++i)
                  values.at(static_cast<std::size_t>(i)) =
                      rgb_at(before, channels, x + i % 3 - 1, y + i / 3 - 1).at(c);
                std::nth_element(values.begin(), values.begin() + 4, values.end());
                middle.at(c) = values[4];
              }
              return middle;
            });
          }};
}

// The light of a square of `side` px times `factor`, where the reference is of middle brightness.
Fault with_patch(const Image& reference, int side_px, double factor) {
  const Rectangle where = place_of_patch(reference, side_px);
  return {fmt::format("{:+.3g} % over {} x {} px", 100 * (factor - 1), side_px, side_px),
          [=](const Image& image) {
            return with_each(image, [&](const Image&, int x, int y, Rgb rgb) {
              if (x >= where.x0 && x < where.x1 && y >= where.y0 && y < where.y1)
                for (double& value : rgb) value *= factor;
              return rgb;
            });
          }};
}

// change(colour, luminance of the reference there over its mean).
template <typename PixelChange>
Fault by_brightness(std::string name, const Image& reference, PixelChange change) {
  return {std::move(name), [&reference, change](const Image& image) {
            const auto channels = rgb_channels(reference);
            const double mean = mean_radiance(reference);
            return with_each(image, [&](const Image&, int x, int y, Rgb rgb) {
              return change(rgb, luminance_of(rgb_at(reference, channels, x, y)) / mean);
            });
          }};
}

Rgb times(double factor, const Rgb& rgb) { return {factor * rgb[0], factor * rgb[1], factor * rgb[2]}; }

void add_light(const Image& reference, std::vector<Fault>& faults) {
  faults.push_back({"+1 % light", [](const Image& image) { return with_more_light(image, 0.01); }});
  faults.push_back({"-1 % light", [](const Image& image) { return with_more_light(image, -0.01); }});
  faults.push_back(scaled_by("-0.09 % light", [](double, double) { return 0.9991; }));
  faults.push_back(scaled_by("gradient of +-9 % in x", [](double x, double) { return 1 + 0.09 * x; }));
  faults.push_back(scaled_by("gradient of +-9 % in y", [](double, double y) { return 1 + 0.09 * y; }));
  faults.push_back(scaled_by("gradient of +-3 % in x", [](double x, double) { return 1 + 0.03 * x; }));
  faults.push_back(
      scaled_by("vignette of 5 %", [](double x, double y) { return 1 - 0.025 * (x * x + y * y); }));
  faults.push_back(by_brightness("shadows 20 % darker", reference, [](const Rgb& rgb, double brightness) {
    return times(brightness < 0.3 ? 0.8 : 1.0, rgb);
  }));
  faults.push_back(by_brightness("highlights 5 % darker", reference, [](const Rgb& rgb, double brightness) {
    return times(brightness > 2 ? 0.95 : 1.0, rgb);
  }));
  faults.push_back(
      by_brightness("black where darker than 5 % of the mean", reference,
                    [](const Rgb& rgb, double brightness) { return times(brightness < 0.05 ? 0 : 1, rgb); }));
  const double mean = mean_radiance(reference);
  faults.push_back(
      mapped("3 % more contrast", [=](double v, std::size_t) { return mean + 1.03 * (v - mean); }));
  faults.push_back(
      mapped("black level + 1 % of the mean", [=](double v, std::size_t) { return v + 0.01 * mean; }));
  faults.push_back(mapped(
      "gamma 1.02", [=](double v, std::size_t) { return v > 0 ? mean * std::pow(v / mean, 1.02) : v; }));
}

void add_colour(std::vector<Fault>& faults) {
  faults.push_back(mixed_with_grey("2 % less saturation", 0.02));
  faults.push_back(mixed_with_grey("3 % less saturation", 0.03));
  faults.push_back(mixed_with_grey("3 % more saturation", -0.03));
  faults.push_back(mapped("R + 1 %, B - 1 %", [](double v, std::size_t c) {
    return v * (1.01 - 0.01 * static_cast<double>(c));
  }));
  faults.push_back({"2 % of R in G", [](const Image& image) {
                      return with_each(image, [](const Image&, int, int, Rgb rgb) {
                        return Rgb{rgb[0], 0.98 * rgb[1] + 0.02 * rgb[0], rgb[2]};
                      });
                    }});
}

void add_geometry(std::vector<Fault>& faults) {
  for (const double px : {0.1, 0.25, 0.5}) {
    faults.push_back(moved(fmt::format("shifted by {} px in x", px), [=](double, double) {
      return std::array{px, 0.0};
    }));
    faults.push_back(moved(fmt::format("shifted by {} px in y", px), [=](double, double) {
      return std::array{0.0, px};
    }));
  }
  faults.push_back(moved("rotated by 0.1 degrees", [](double x, double y) {
    constexpr double kRadians = 0.1 * 3.14159265358979 / 180;
    return std::array{-kRadians * y, kRadians * x};
  }));
  faults.push_back(moved("scaled by 0.2 %", [](double x, double y) {
    return std::array{0.002 * x, 0.002 * y};
  }));
}

void add_filters(std::vector<Fault>& faults) {
  faults.push_back(blurred("blur of sigma 0.3 px", 0.3, 1));
  faults.push_back(blurred("blur of sigma 0.4 px", 0.4, 1));
  faults.push_back(blurred("blur of sigma 0.5 px", 0.5, 1));
  faults.push_back(blurred("blur of sigma 1 px", 1, 1));
  faults.push_back(blurred("sharpened by a tenth", 1, -0.1));
  faults.push_back(median_filtered());
}

void add_steps_and_stripes(std::vector<Fault>& faults) {
  const auto quantised = [](int levels) {
    return [=](double v, std::size_t) {
      if (v < 0 || v > 1) return v;
      const auto encoded = static_cast<double>(image::srgb_encode(static_cast<float>(v)));
      return static_cast<double>(
          image::srgb_decode(static_cast<float>(std::round(encoded * levels) / levels)));
    };
  };
  faults.push_back(mapped("quantised to 8 bits", quantised(255)));
  faults.push_back(mapped("quantised to 6 bits", quantised(63)));
  faults.push_back(mapped("cut to 8 bits", [](double v, std::size_t) { return std::floor(v * 255) / 255; }));
  const auto striped = [](std::string name, std::function<bool(int, int)> is_bright) {
    return Fault{std::move(name), [is_bright = std::move(is_bright)](const Image& image) {
                   return with_each(image, [&](const Image&, int x, int y, const Rgb& rgb) {
                     return times(is_bright(x, y) ? 1.05 : 0.95, rgb);
                   });
                 }};
  };
  faults.push_back(striped("chequered by +-5 %", [](int x, int y) { return (x + y) % 2 == 0; }));
  faults.push_back(striped("columns of +-5 %", [](int x, int) { return x % 2 == 0; }));
  faults.push_back(striped("rows of 5 px of +-5 %", [](int, int y) { return y / 5 % 2 == 0; }));
  faults.push_back(
      striped("squares of 8 px of +-5 %", [](int x, int y) { return (x / 8 + y / 8) % 2 == 0; }));
  faults.push_back(mapped("clamped at 0.8", [](double v, std::size_t) { return std::min(v, 0.8); }));
}

}  // namespace

std::vector<Fault> subtle_faults(const Image& reference) {
  std::vector<Fault> faults;
  add_light(reference, faults);
  add_colour(faults);
  add_geometry(faults);
  add_filters(faults);
  add_steps_and_stripes(faults);
  for (const auto& [side_px, factor] : {std::pair{96, 1.02},
                                        {64, 1.02},
                                        {64, 0.98},
                                        {32, 1.03},
                                        {16, 1.05},
                                        {16, 0.95},
                                        {20, 0.0},
                                        {12, 1.2},
                                        {6, 2.0},
                                        {3, 4.0}})
    faults.push_back(with_patch(reference, side_px, factor));
  return faults;
}

}  // namespace orbs::studies
