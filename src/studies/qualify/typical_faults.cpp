#include "studies/qualify/typical_faults.h"

#include "image/colour.h"
#include "studies/qualify/subtle_faults.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>

#include <fmt/format.h>

namespace orbs::studies {

namespace {

using image::Image;

// Moves all channels, the variances too. Beyond its edge the image continues as its edge pixels.
Image moved(const Image& image, int dx, int dy) {
  Image out = image;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      for (std::size_t c = 0; c < image.channel_count(); ++c)
        out.at(x, y, c) =
            image.at(std::clamp(x - dx, 0, image.width - 1), std::clamp(y - dy, 0, image.height - 1), c);
  return out;
}

// The mean of two images of the same noise: that of a camera half a pixel beside.
Image between(const Image& a, const Image& b) {
  Image out = a;
  for (std::size_t i = 0; i < out.pixels.size(); ++i) out.pixels[i] = (a.pixels[i] + b.pixels[i]) / 2;
  return out;
}

Image turned(const Image& image, bool in_x, bool in_y) {
  Image out = image;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      for (std::size_t c = 0; c < image.channel_count(); ++c)
        out.at(x, y, c) = image.at(in_x ? image.width - 1 - x : x, in_y ? image.height - 1 - y : y, c);
  return out;
}

// The colours changed; the variances stay.
Change each_value(std::function<float(float)> map) {
  return [map = std::move(map)](const Image& image) {
    Image out = image;
    for (std::size_t i = 0; i < out.pixels.size(); ++i)
      if (!image::is_variance(image.channels[i % image.channel_count()])) out.pixels[i] = map(out.pixels[i]);
    return out;
  };
}

Image swapped(const Image& image, const char* a, const char* b) {
  Image out = image;
  for (const char* prefix : {"", "variance."}) {
    const int from = image::channel_index(image, std::string(prefix) + a);
    const int to = image::channel_index(image, std::string(prefix) + b);
    if (from < 0 || to < 0) continue;
    for (std::size_t i = 0; i < out.pixels.size(); i += out.channel_count())
      std::swap(out.pixels[i + static_cast<std::size_t>(from)], out.pixels[i + static_cast<std::size_t>(to)]);
  }
  return out;
}

Image mean_of_3x3(const Image& image) {
  Image sum = image::make_image(image.width, image.height, image.channels);
  for (int dy = -1; dy <= 1; ++dy)
    for (int dx = -1; dx <= 1; ++dx) {
      const Image one = moved(image, dx, dy);
      for (std::size_t i = 0; i < sum.pixels.size(); ++i) sum.pixels[i] += one.pixels[i] / 9;
    }
  return sum;
}

Image outside_black(const Image& image) {
  Image out = image;
  const int margin = std::max(1, image.width / 8);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      if (x < margin || x >= image.width - margin)
        for (std::size_t c = 0; c < image.channel_count(); ++c) out.at(x, y, c) = 0;
  return out;
}

// An alpha that rises from left to right, and colours that were multiplied by it.
Image premultiplied(const Image& image) {
  auto names = image.channels;
  names.emplace_back("A");
  Image out = image::make_image(image.width, image.height, names);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const float alpha = 0.3F + 0.7F * static_cast<float>(x) / static_cast<float>(image.width);
      for (std::size_t c = 0; c < image.channel_count(); ++c)
        out.at(x, y, c) = image.at(x, y, c) * (image::is_variance(image.channels[c]) ? alpha * alpha : alpha);
      out.at(x, y, image.channel_count()) = alpha;
    }
  return out;
}

Image magnified_by_a_quarter(const Image& image) {
  Image out = image;
  const auto source = [](int at, int size) {
    return std::clamp(static_cast<int>(std::lround((at - (size - 1) / 2.0) / 1.25 + (size - 1) / 2.0)), 0,
                      size - 1);
  };
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      for (std::size_t c = 0; c < image.channel_count(); ++c)
        out.at(x, y, c) = image.at(source(x, image.width), source(y, image.height), c);
  return out;
}

// The value that the brightest hundredth of the samples exceed.
float bright_value(const Image& image) {
  auto values = image::select_rgb(image, "").pixels;
  const auto at = static_cast<std::ptrdiff_t>(values.size() - 1 - values.size() / 100);
  std::nth_element(values.begin(), values.begin() + at, values.end());
  return values[static_cast<std::size_t>(at)];
}

void add_places(std::vector<TypicalFault>& faults) {
  for (const auto& [dx, dy] : {std::pair{1, 0}, {2, 1}, {-3, 5}})
    faults.push_back({{fmt::format("shifted by ({}, {}) px", dx, dy),
                       [dx = dx, dy = dy](const Image& image) { return moved(image, dx, dy); }},
                      fmt::format("shifted by ({}, {}) px", dx, dy)});
  faults.push_back({{"shifted by half a pixel in x",
                     [](const Image& image) { return between(image, moved(image, 1, 0)); }},
                    "shifted by (0.5, 0) px"});
  faults.push_back({{"shifted by half a pixel in x and y",
                     [](const Image& image) {
                       return between(between(image, moved(image, 1, 0)),
                                      between(moved(image, 0, 1), moved(image, 1, 1)));
                     }},
                    "shifted by (0.5, 0.5) px"});
  faults.push_back({{"mirrored", [](const Image& image) { return turned(image, true, false); }}, "mirrored"});
  faults.push_back(
      {{"upside down", [](const Image& image) { return turned(image, false, true); }}, "upside down"});
  faults.push_back({{"turned by 180 degrees", [](const Image& image) { return turned(image, true, true); }},
                    "turned by 180 degrees"});
  faults.push_back({{"magnified by 1.25", magnified_by_a_quarter}, "magnified by 1.25"});
  faults.push_back({{"cropped", outside_black}, "cropped"});
}

void add_values(const Image& reference, std::vector<TypicalFault>& faults) {
  const auto factor = [&](std::string name, double by, std::string expected) {
    faults.push_back({{std::move(name), [=](const Image& image) { return with_more_light(image, by - 1); }},
                      std::move(expected)});
  };
  factor("times pi", std::numbers::pi, "multiplied by pi");
  factor("times 1/pi", 1 / std::numbers::pi, "multiplied by 1/pi");
  factor("times 2", 2, "multiplied by 2");
  factor("3 % less light", 0.97, "multiplied by 0.9");
  faults.push_back({{"sRGB encoded", each_value(image::srgb_encode)}, "encoded for the screen"});
  faults.push_back({{"sRGB decoded", each_value(image::srgb_decode)}, "decoded from"});
  faults.push_back({{"8-bit range and sRGB", each_value([](float value) {
                       return image::srgb_encode(std::clamp(value, 0.0F, 1.0F));
                     })},
                    "encoded for the screen"});
  faults.push_back({{"R and B swapped", [](const Image& image) { return swapped(image, "R", "B"); }},
                    "with R and B swapped"});
  faults.push_back({{"G and B swapped", [](const Image& image) { return swapped(image, "G", "B"); }},
                    "with G and B swapped"});
  const float bright = bright_value(reference);
  faults.push_back(
      {{"brightest hundredth clamped", each_value([bright](float value) { return std::min(value, bright); })},
       "clamped at"});
  faults.push_back({{"premultiplied", premultiplied}, "multiplied by its alpha"});
  const auto offset = static_cast<float>(0.1 * mean_radiance(reference));
  faults.push_back(
      {{"a tenth of the mean added", each_value([offset](float value) { return value + offset; })},
       "off by +"});
}

// Those of the other studies that are what they are called.
void add_known(const Image& reference, std::vector<TypicalFault>& faults) {
  const std::map<std::string, std::string> expected{{"half resolution", "of 1/2 of the resolution"},
                                                    {"blur of sigma 1 px", "blurred by a filter of 2.4 px"},
                                                    {"gradient of +-9 % in x", ""},
                                                    {"vignette of 5 %", ""},
                                                    {"shadows 20 % darker", ""},
                                                    {"R + 1 %, B - 1 %", ""},
                                                    {"columns of +-5 %", ""},
                                                    {"-100 % over 20 x 20 px", ""}};
  for (const auto& list : {faults_of(reference), subtle_faults(reference)})
    for (const auto& fault : list)
      if (const auto known = expected.find(fault.name); known != expected.end())
        faults.push_back({fault, known->second});
  faults.push_back({{"mean of 3 x 3 px", mean_of_3x3}, "blurred by a"});
}

void add_wrong_images(const Image& reference,
                      const std::map<std::string, Image>& other_targets,
                      std::vector<TypicalFault>& faults) {
  const Rectangle where = place_of_leak(reference, {});
  const double mean = mean_radiance(reference);
  faults.push_back(
      {{"a leak into 16 x 16 px", [=](const Image& image) { return with_leak(image, where, mean); }}, ""});
  for (const auto& [name, other] : other_targets)
    if (other.width == reference.width && other.height == reference.height)
      faults.push_back({{"the image of another target", [&other = other](const Image&) { return other; }},
                        fmt::format("the image of '{}'", name)});
}

}  // namespace

std::vector<TypicalFault> typical_faults(const Image& reference,
                                         const std::map<std::string, Image>& other_targets) {
  std::vector<TypicalFault> faults;
  add_places(faults);
  add_values(reference, faults);
  add_known(reference, faults);
  add_wrong_images(reference, other_targets, faults);
  return faults;
}

}  // namespace orbs::studies
