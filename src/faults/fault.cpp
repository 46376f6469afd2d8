#include "faults/fault.h"

#include "base/nth.h"
#include "faults/pixels.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <numbers>
#include <utility>

#include <fmt/format.h>

namespace orbs::faults {

namespace {

using image::Image;
using enum Use;

using Rows = std::vector<Row>;

void add(Rows& all, Rows rows) {
  all.insert(all.end(), std::make_move_iterator(rows.begin()), std::make_move_iterator(rows.end()));
}

// A fault as renderers make it, and how the right diagnosis begins.
Row typical(std::string name, Fault fault, std::string diagnosis, Reach reach = Reach::AllChannels) {
  return {std::move(name), std::move(fault), {Diagnosis}, std::move(diagnosis), reach};
}

Row typical_of_colours(std::string name, Fault fault, std::string diagnosis) {
  return typical(std::move(name), std::move(fault), std::move(diagnosis), Reach::Colours);
}

// A fault of the colours near the size at which noise begins to hide it.
Row slight(std::string name, Fault fault) {
  return {std::move(name), std::move(fault), {Sensitivity}, "", Reach::Colours};
}

// The same, which is diagnosed, too.
Row shared(std::string name, Fault fault, std::string diagnosis) {
  return {std::move(name), std::move(fault), {Sensitivity, Diagnosis}, std::move(diagnosis), Reach::Colours};
}

// The same, which the diagnosis must not take for a fault that it knows.
Row unusual(std::string name, Fault fault) { return shared(std::move(name), std::move(fault), ""); }

std::string swap_name(const ChannelOrder& order) {
  std::string names;
  for (std::size_t c = 0; c < 3; ++c)
    if (order.from.at(c) != c) names += fmt::format("{}{}", names.empty() ? "" : " and ", kColours.at(c));
  return names + " swapped";
}

Rows unmistakable(const Image& reference) {
  const auto swap = most_visible_swap(reference);
  return {{"black", Factor{0}, {Mutation}},
          {"constant", Constant{}, {Mutation}},
          {"half the light", Factor{0.5}, {Mutation}},
          {"one NaN", InvalidPixel{}, {Mutation}},
          {"shifted by 1 px", Shift{1, 0}, {Mutation}},
          {"+2 % light", Factor{1.02}, {Mutation}},
          {"-2 % light", Factor{0.98}, {Mutation}},
          {swap_name(swap), swap, {Mutation}},
          {"sRGB twice", Curve{Curve::Kind::SrgbEncoded}, {Mutation}}};
}

Rows misplaced(const Image& reference) {
  const int margin = std::max(1, reference.width / 8);
  const Crop cropped{{margin, 0, reference.width - margin, reference.height}};
  return {
      typical("shifted by (1, 0) px", Shift{1, 0}, "shifted by (1, 0) px"),
      typical("shifted by (2, 1) px", Shift{2, 1}, "shifted by (2, 1) px"),
      typical("shifted by (-3, 5) px", Shift{-3, 5}, "shifted by (-3, 5) px"),
      typical("shifted by half a pixel in x", Shift{0.5, 0}, "shifted by (0.5, 0) px"),
      typical("shifted by half a pixel in x and y", Shift{0.5, 0.5}, "shifted by (0.5, 0.5) px"),
      typical("mirrored", Turn{.mirrors_x = true}, "mirrored"),
      typical("upside down", Turn{.mirrors_y = true}, "upside down"),
      typical("turned by 180 degrees", Turn{.mirrors_x = true, .mirrors_y = true}, "turned by 180 degrees"),
      typical("magnified by 1.25", Magnification{1.25, Between::Nearest}, "magnified by 1.25"),
      typical("cropped", cropped, "cropped")};
}

// The value that the brightest hundredth of the samples exceed.
float bright_value(const Image& image) {
  auto values = image::select_rgb(image, "").pixels;
  const auto at = static_cast<std::ptrdiff_t>(values.size() - 1 - values.size() / 100);
  std::nth_element(values.begin(), values.begin() + at, values.end());
  return nth(values, at);
}

// An alpha that rises from left to right.
Alpha rising_alpha(const Image& image) {
  Alpha fault;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      fault.alpha.push_back(0.3F + 0.7F * static_cast<float>(x) / static_cast<float>(image.width));
  return fault;
}

Rows wrong_values(const Image& reference) {
  using Kind = Curve::Kind;
  const Clamp clamp{bright_value(reference)};
  const Offset offset{0.1 * mean_radiance(reference)};
  return {typical("times pi", Factor{std::numbers::pi}, "multiplied by pi"),
          typical("times 1/pi", Factor{1 / std::numbers::pi}, "multiplied by 1/pi"),
          typical("times 2", Factor{2}, "multiplied by 2"),
          typical("3 % less light", Factor{0.97}, "multiplied by 0.9"),
          typical_of_colours("sRGB encoded", Curve{Kind::SrgbEncoded}, "encoded for the screen"),
          typical_of_colours("sRGB decoded", Curve{Kind::SrgbDecoded}, "decoded from"),
          typical_of_colours("8-bit range and sRGB", Curve{Kind::SrgbEncodedAndClamped},
                             "encoded for the screen"),
          typical("R and B swapped", ChannelOrder{{2, 1, 0}}, "with R and B swapped"),
          typical("G and B swapped", ChannelOrder{{0, 2, 1}}, "with G and B swapped"),
          typical_of_colours("brightest hundredth clamped", clamp, "clamped at"),
          typical("premultiplied", rising_alpha(reference), "multiplied by its alpha"),
          typical_of_colours("a tenth of the mean added", offset, "off by +")};
}

Rows slight_light(const Image& reference) {
  const double mean = mean_radiance(reference);
  const Brightness shadows{.reference = &reference, .factor = 0.8, .below = 0.3};
  const Brightness highlights{.reference = &reference, .factor = 0.95, .above = 2};
  const Brightness black{.reference = &reference, .factor = 0, .below = 0.05};
  return {{"+1 % light", Factor{1.01}, {Sensitivity}},
          {"-1 % light", Factor{0.99}, {Sensitivity}},
          slight("-0.09 % light", Factor{0.9991}),
          unusual("gradient of +-9 % in x", Gradient{0.09, 0}),
          slight("gradient of +-9 % in y", Gradient{0, 0.09}),
          slight("gradient of +-3 % in x", Gradient{0.03, 0}),
          unusual("vignette of 5 %", Vignette{0.05}),
          unusual("shadows 20 % darker", shadows),
          slight("highlights 5 % darker", highlights),
          slight("black where darker than 5 % of the mean", black),
          slight("3 % more contrast", Contrast{mean, 1.03}),
          slight("black level + 1 % of the mean", Offset{0.01 * mean}),
          slight("gamma 1.02", Power{mean, 1.02})};
}

Rows slight_colour() {
  const ColourMatrix warmer{{{{1.01, 0, 0}, {0, 1, 0}, {0, 0, 0.99}}}};
  const ColourMatrix mixed{{{{1, 0, 0}, {0.02, 0.98, 0}, {0, 0, 1}}}};
  return {slight("2 % less saturation", less_saturated(0.02)),
          slight("3 % less saturation", less_saturated(0.03)),
          slight("3 % more saturation", less_saturated(-0.03)), unusual("R + 1 %, B - 1 %", warmer),
          slight("2 % of R in G", mixed)};
}

Rows slight_geometry_and_filters() {
  Rows rows;
  for (const double px : {0.1, 0.25, 0.5})
    add(rows, {slight(fmt::format("shifted by {} px in x", px), Shift{px, 0}),
               slight(fmt::format("shifted by {} px in y", px), Shift{0, px})});
  add(rows, {slight("rotated by 0.1 degrees", Rotation{0.1}),
             slight("scaled by 0.2 %", Magnification{1 / 0.998}), slight("blur of sigma 0.3 px", Blur{0.3}),
             slight("blur of sigma 0.4 px", Blur{0.4}), slight("blur of sigma 0.5 px", Blur{0.5}),
             shared("blur of sigma 1 px", Blur{1}, "blurred by a filter of 2.4 px"),
             slight("sharpened by a tenth", Blur{.width_px = 1, .share = -0.1}),
             slight("median of 3 x 3 px", Median{})});
  return rows;
}

Rows steps_and_patterns() {
  return {slight("quantised to 8 bits", Steps{255}),
          slight("quantised to 6 bits", Steps{63}),
          slight("cut to 8 bits", Steps{255, Steps::Kind::Cut}),
          slight("chequered by +-5 %", Pattern{1, 1, 0.05}),
          unusual("columns of +-5 %", Pattern{1, 0, 0.05}),
          slight("rows of 5 px of +-5 %", Pattern{0, 5, 0.05}),
          slight("squares of 8 px of +-5 %", Pattern{8, 8, 0.05}),
          slight("clamped at 0.8", Clamp{0.8F})};
}

// The light of a square times a factor, where the reference is of middle brightness.
Row patch(Row (*row)(std::string, Fault), const Image& reference, int side_px, double factor) {
  return row(fmt::format("{:+.3g} % over {} x {} px", 100 * (factor - 1), side_px, side_px),
             Patch{middle_patch(reference, side_px), factor});
}

Rows patches(const Image& reference) {
  return {patch(slight, reference, 96, 1.02), patch(slight, reference, 64, 1.02),
          patch(slight, reference, 64, 0.98), patch(slight, reference, 32, 1.03),
          patch(slight, reference, 16, 1.05), patch(slight, reference, 16, 0.95),
          patch(unusual, reference, 20, 0),   patch(slight, reference, 12, 1.2),
          patch(slight, reference, 6, 2),     patch(slight, reference, 3, 4)};
}

}  // namespace

std::vector<Row> catalogue(const Image& reference, const std::vector<std::uint8_t>& included) {
  const auto leak = leak_of_mean_light(reference, included);
  Rows rows = unmistakable(reference);
  add(rows, misplaced(reference));
  add(rows, wrong_values(reference));
  add(rows, {{"half resolution", Resolution{2}, {Mutation, Diagnosis}, "of 1/2 of the resolution"},
             {"clamped at 1", Clamp{1}, {Mutation}},
             {"a leak of the mean light into 16 x 16 px", leak, {Mutation}}});
  add(rows, slight_light(reference));
  add(rows, slight_colour());
  add(rows, slight_geometry_and_filters());
  add(rows, steps_and_patterns());
  add(rows, patches(reference));
  add(rows, {typical("mean of 3 x 3 px", Blur{3, Blur::Filter::Box}, "blurred by a"),
             typical("a leak into 16 x 16 px", leak, "")});
  return rows;
}

std::vector<Row> rows_of(Use use, const Image& reference, const std::vector<std::uint8_t>& included) {
  auto rows = catalogue(reference, included);
  std::erase_if(rows, [&](const Row& row) {
    return std::find(row.uses.begin(), row.uses.end(), use) == row.uses.end();
  });
  return rows;
}

Image applied(const Row& row, const Image& image) {
  const auto faulty = [&](const Image& one) {
    return std::visit([&](const auto& fault) { return fault.apply(one); }, row.fault);
  };
  if (row.reach == Reach::AllChannels) return faulty(image);
  const Image colours = faulty(image::select_rgb(image, ""));
  Image out = image;
  for (std::size_t colour = 0; colour < 3; ++colour) {
    const auto channel = colour_index(image, colour);
    for (std::size_t pixel = 0; pixel < image.pixel_count(); ++pixel)
      out.pixels[pixel * image.channel_count() + channel] = colours.pixels[3 * pixel + colour];
  }
  return out;
}

bool is_same_kind(const Fault& a, const Fault& b) { return a.index() == b.index(); }

}  // namespace orbs::faults
