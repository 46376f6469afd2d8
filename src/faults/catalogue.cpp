#include "faults/fault.h"
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

std::string swap_name(const ChannelOrder& order) {
  std::string names;
  for (std::size_t c = 0; c < 3; ++c)
    if (order.from.at(c) != c) names += fmt::format("{}{}", names.empty() ? "" : " and ", kColours.at(c));
  return names + " swapped";
}

Rows unmistakable(const Image& reference) {
  const auto swap = most_visible_swap(reference);
  return {
      {"black", Factor{0}, {Mutation}},         {"constant", Constant{}, {Mutation}},
      {"one NaN", InvalidPixel{}, {Mutation}},  {"shifted by 1 px", Shift{1, 0}, {Mutation}},
      {"+2 % light", Factor{1.02}, {Mutation}}, {"-2 % light", Factor{0.98}, {Mutation}},
      {swap_name(swap), swap, {Mutation}},      {"sRGB twice", Curve{Curve::Kind::SrgbEncoded}, {Mutation}}};
}

Rows misplaced(const Image& reference) {
  const int margin = std::max(1, reference.width / 8);
  const Crop cropped{{margin, 0, reference.width - margin, reference.height}};
  return {{"shifted by (1, 0) px", Shift{1, 0}, {Diagnosis}, "shifted by (1, 0) px"},
          {"shifted by (2, 1) px", Shift{2, 1}, {Diagnosis}, "shifted by (2, 1) px"},
          {"shifted by (-3, 5) px", Shift{-3, 5}, {Diagnosis}, "shifted by (-3, 5) px"},
          {"shifted by half a pixel in x", Shift{0.5, 0}, {Diagnosis}, "shifted by (0.5, 0) px"},
          {"shifted by half a pixel in x and y", Shift{0.5, 0.5}, {Diagnosis}, "shifted by (0.5, 0.5) px"},
          {"mirrored", Turn{.mirrors_x = true}, {Diagnosis}, "mirrored"},
          {"upside down", Turn{.mirrors_y = true}, {Diagnosis}, "upside down"},
          {"turned by 180 degrees",
           Turn{.mirrors_x = true, .mirrors_y = true},
           {Diagnosis},
           "turned by 180 degrees"},
          {"magnified by 1.25", Magnification{1.25, Between::Nearest}, {Diagnosis}, "magnified by 1.25"},
          {"cropped", cropped, {Diagnosis}, "cropped"}};
}

// The value that the brightest hundredth of the samples exceed.
float bright_value(const Image& image) {
  auto values = image::select_rgb(image, "").pixels;
  const auto at = static_cast<std::ptrdiff_t>(values.size() - 1 - values.size() / 100);
  std::nth_element(values.begin(), values.begin() + at, values.end());
  return values[static_cast<std::size_t>(at)];
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
  constexpr double kPi = std::numbers::pi;
  constexpr auto kColoursOnly = Reach::Colours;
  return {
      {"times pi", Factor{kPi}, {Diagnosis}, "multiplied by pi"},
      {"times 1/pi", Factor{1 / kPi}, {Diagnosis}, "multiplied by 1/pi"},
      {"times 2", Factor{2}, {Diagnosis}, "multiplied by 2"},
      {"3 % less light", Factor{0.97}, {Diagnosis}, "multiplied by 0.9"},
      {"sRGB encoded", Curve{Curve::Kind::SrgbEncoded}, {Diagnosis}, "encoded for the screen", kColoursOnly},
      {"sRGB decoded", Curve{Curve::Kind::SrgbDecoded}, {Diagnosis}, "decoded from", kColoursOnly},
      {"8-bit range and sRGB",
       Curve{Curve::Kind::SrgbEncodedAndClamped},
       {Diagnosis},
       "encoded for the screen",
       kColoursOnly},
      {"R and B swapped", ChannelOrder{{2, 1, 0}}, {Diagnosis}, "with R and B swapped"},
      {"G and B swapped", ChannelOrder{{0, 2, 1}}, {Diagnosis}, "with G and B swapped"},
      {"brightest hundredth clamped",
       Clamp{bright_value(reference)},
       {Diagnosis},
       "clamped at",
       kColoursOnly},
      {"premultiplied", rising_alpha(reference), {Diagnosis}, "multiplied by its alpha"},
      {"a tenth of the mean added",
       Offset{0.1 * mean_radiance(reference)},
       {Diagnosis},
       "off by +",
       kColoursOnly}};
}

Rows slight_light(const Image& reference) {
  constexpr auto kColoursOnly = Reach::Colours;
  const double mean = mean_radiance(reference);
  return {{"+1 % light", Factor{1.01}, {Sensitivity}},
          {"-1 % light", Factor{0.99}, {Sensitivity}},
          {"-0.09 % light", Factor{0.9991}, {Sensitivity}, "", kColoursOnly},
          {"gradient of +-9 % in x", Gradient{0.09, 0}, {Sensitivity, Diagnosis}, "", kColoursOnly},
          {"gradient of +-9 % in y", Gradient{0, 0.09}, {Sensitivity}, "", kColoursOnly},
          {"gradient of +-3 % in x", Gradient{0.03, 0}, {Sensitivity}, "", kColoursOnly},
          {"vignette of 5 %", Vignette{0.05}, {Sensitivity, Diagnosis}, "", kColoursOnly},
          {"shadows 20 % darker",
           Brightness{.reference = &reference, .factor = 0.8, .below = 0.3},
           {Sensitivity, Diagnosis},
           "",
           kColoursOnly},
          {"highlights 5 % darker",
           Brightness{.reference = &reference, .factor = 0.95, .above = 2},
           {Sensitivity},
           "",
           kColoursOnly},
          {"black where darker than 5 % of the mean",
           Brightness{.reference = &reference, .factor = 0, .below = 0.05},
           {Sensitivity},
           "",
           kColoursOnly},
          {"3 % more contrast", Contrast{mean, 1.03}, {Sensitivity}, "", kColoursOnly},
          {"black level + 1 % of the mean", Offset{0.01 * mean}, {Sensitivity}, "", kColoursOnly},
          {"gamma 1.02", Power{mean, 1.02}, {Sensitivity}, "", kColoursOnly}};
}

Rows slight_colour() {
  constexpr auto kColoursOnly = Reach::Colours;
  const ColourMatrix warmer{{{{1.01, 0, 0}, {0, 1, 0}, {0, 0, 0.99}}}};
  const ColourMatrix mixed{{{{1, 0, 0}, {0.02, 0.98, 0}, {0, 0, 1}}}};
  return {{"2 % less saturation", less_saturated(0.02), {Sensitivity}, "", kColoursOnly},
          {"3 % less saturation", less_saturated(0.03), {Sensitivity}, "", kColoursOnly},
          {"3 % more saturation", less_saturated(-0.03), {Sensitivity}, "", kColoursOnly},
          {"R + 1 %, B - 1 %", warmer, {Sensitivity, Diagnosis}, "", kColoursOnly},
          {"2 % of R in G", mixed, {Sensitivity}, "", kColoursOnly}};
}

Rows slight_geometry_and_filters() {
  constexpr auto kColoursOnly = Reach::Colours;
  Rows rows;
  for (const double px : {0.1, 0.25, 0.5}) {
    rows.push_back({fmt::format("shifted by {} px in x", px), Shift{px, 0}, {Sensitivity}, "", kColoursOnly});
    rows.push_back({fmt::format("shifted by {} px in y", px), Shift{0, px}, {Sensitivity}, "", kColoursOnly});
  }
  add(rows, {{"rotated by 0.1 degrees", Rotation{0.1}, {Sensitivity}, "", kColoursOnly},
             {"scaled by 0.2 %", Magnification{1 / 0.998}, {Sensitivity}, "", kColoursOnly},
             {"blur of sigma 0.3 px", Blur{0.3}, {Sensitivity}, "", kColoursOnly},
             {"blur of sigma 0.4 px", Blur{0.4}, {Sensitivity}, "", kColoursOnly},
             {"blur of sigma 0.5 px", Blur{0.5}, {Sensitivity}, "", kColoursOnly},
             {"blur of sigma 1 px",
              Blur{1},
              {Sensitivity, Diagnosis},
              "blurred by a filter of 2.4 px",
              kColoursOnly},
             {"sharpened by a tenth", Blur{.width_px = 1, .share = -0.1}, {Sensitivity}, "", kColoursOnly},
             {"median of 3 x 3 px", Median{}, {Sensitivity}, "", kColoursOnly}});
  return rows;
}

Rows steps_and_patterns() {
  constexpr auto kColoursOnly = Reach::Colours;
  return {{"quantised to 8 bits", Steps{255}, {Sensitivity}, "", kColoursOnly},
          {"quantised to 6 bits", Steps{63}, {Sensitivity}, "", kColoursOnly},
          {"cut to 8 bits", Steps{255, Steps::Kind::Cut}, {Sensitivity}, "", kColoursOnly},
          {"chequered by +-5 %", Pattern{1, 1, 0.05}, {Sensitivity}, "", kColoursOnly},
          {"columns of +-5 %", Pattern{1, 0, 0.05}, {Sensitivity, Diagnosis}, "", kColoursOnly},
          {"rows of 5 px of +-5 %", Pattern{0, 5, 0.05}, {Sensitivity}, "", kColoursOnly},
          {"squares of 8 px of +-5 %", Pattern{8, 8, 0.05}, {Sensitivity}, "", kColoursOnly},
          {"clamped at 0.8", Clamp{0.8F}, {Sensitivity}, "", kColoursOnly}};
}

// The light of squares times a factor, where the reference is of middle brightness.
Rows patches(const Image& reference) {
  struct Size {
    int side_px;
    double factor;
    std::vector<Use> uses;
  };
  const std::vector<Size> sizes{{96, 1.02, {Sensitivity}},
                                {64, 1.02, {Sensitivity}},
                                {64, 0.98, {Sensitivity}},
                                {32, 1.03, {Sensitivity}},
                                {16, 1.05, {Sensitivity}},
                                {16, 0.95, {Sensitivity}},
                                {20, 0, {Sensitivity, Diagnosis}},
                                {12, 1.2, {Sensitivity}},
                                {6, 2, {Sensitivity}},
                                {3, 4, {Sensitivity}}};
  Rows rows;
  for (const auto& [side_px, factor, uses] : sizes)
    rows.push_back({fmt::format("{:+.3g} % over {} x {} px", 100 * (factor - 1), side_px, side_px),
                    Patch{middle_patch(reference, side_px), factor}, uses, "", Reach::Colours});
  return rows;
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
  add(rows, {{"mean of 3 x 3 px", Blur{3, Blur::Filter::Box}, {Diagnosis}, "blurred by a"},
             {"a leak into 16 x 16 px", leak, {Diagnosis}}});
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
