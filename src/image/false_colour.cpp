#include "image/false_colour.h"

#include "base/error.h"
#include "base/nth.h"
#include "image/colour.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

namespace orbs::image {

namespace {

using Rgb = std::array<float, 3>;

constexpr Rgb kNoValue{0.5F, 0.5F, 0.5F};

struct LightnessChromaHue {
  double lightness;  // of OKLab, 0 black to 1 white
  double chroma;
  double hue_deg;
};

// OKLab to linear Rec.709: B. Ottosson, "A perceptual color space for image processing", 2020. Colours are
// made there because equal steps of its lightness look equal.
std::array<double, 3> linear_rgb(LightnessChromaHue colour) {
  const double hue_rad = colour.hue_deg * std::numbers::pi / 180.0;
  const double a = colour.chroma * std::cos(hue_rad);
  const double b = colour.chroma * std::sin(hue_rad);
  const auto cube = [](double v) { return v * v * v; };
  const double l = cube(colour.lightness + 0.3963377774 * a + 0.2158037573 * b);
  const double m = cube(colour.lightness - 0.1055613458 * a - 0.0638541728 * b);
  const double s = cube(colour.lightness - 0.0894841775 * a - 1.2914855480 * b);
  return {4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
          -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
          -0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s};
}

// The numbers of both scales were chosen so that every colour lies inside sRGB: nothing is cut, lightness
// stays linear.
LightnessChromaHue sequential(double t) {
  return {0.15 + 0.83 * t, 0.045 + 0.52 * t * (1.0 - t), 290.0 + 175.0 * t};
}

LightnessChromaHue diverging(double t) {
  constexpr double kOrange_deg = 50.0;
  constexpr double kBlue_deg = 255.0;
  return {0.12 + 0.63 * std::fabs(t), 0.13 * std::fabs(t), t < 0.0 ? kBlue_deg : kOrange_deg};
}

float signed_largest(const float* values, std::size_t count) {
  float largest = values[0];
  for (std::size_t c = 0; c < count; ++c) {
    if (std::isnan(values[c])) return values[c];
    if (std::fabs(values[c]) > std::fabs(largest)) largest = values[c];
  }
  return largest;
}

// An image has far more pixels than 8-bit output has colours.
std::vector<Rgb> colour_table(ColourScale scale) {
  constexpr int kEntries = 1024;
  const float start = scale == ColourScale::Diverging ? -1.0F : 0.0F;
  std::vector<Rgb> table;
  table.reserve(kEntries + 1);
  for (int i = 0; i <= kEntries; ++i)
    table.push_back(colour_at(scale, start + (1.0F - start) * static_cast<float>(i) / kEntries));
  return table;
}

struct Colouring {
  ColourScale scale;
  float maximum;
  std::vector<Rgb> table;

  Rgb operator()(float value) const {
    if (std::isnan(value)) return kNoValue;
    const float position = maximum > 0.0F ? std::clamp(value / maximum, -1.0F, 1.0F) : 0.0F;
    const float share = scale == ColourScale::Diverging ? 0.5F * (position + 1.0F) : std::max(position, 0.0F);
    return nth(table, std::lround(share * static_cast<float>(table.size() - 1)));
  }
};

struct Glyph {
  char character;
  std::array<std::uint8_t, kGlyphHeightPx> rows;  // five dots a row, the leftmost is the highest bit
};

constexpr std::array kGlyphs{
    Glyph{'0', {0b01110, 0b10001, 0b10011, 0b10101, 0b11001, 0b10001, 0b01110}},
    Glyph{'1', {0b00100, 0b01100, 0b00100, 0b00100, 0b00100, 0b00100, 0b01110}},
    Glyph{'2', {0b01110, 0b10001, 0b00001, 0b00110, 0b01000, 0b10000, 0b11111}},
    Glyph{'3', {0b11110, 0b00001, 0b00001, 0b01110, 0b00001, 0b00001, 0b11110}},
    Glyph{'4', {0b00010, 0b00110, 0b01010, 0b10010, 0b11111, 0b00010, 0b00010}},
    Glyph{'5', {0b11111, 0b10000, 0b11110, 0b00001, 0b00001, 0b10001, 0b01110}},
    Glyph{'6', {0b00110, 0b01000, 0b10000, 0b11110, 0b10001, 0b10001, 0b01110}},
    Glyph{'7', {0b11111, 0b00001, 0b00010, 0b00100, 0b01000, 0b01000, 0b01000}},
    Glyph{'8', {0b01110, 0b10001, 0b10001, 0b01110, 0b10001, 0b10001, 0b01110}},
    Glyph{'9', {0b01110, 0b10001, 0b10001, 0b01111, 0b00001, 0b00010, 0b01100}},
    Glyph{'.', {0b00000, 0b00000, 0b00000, 0b00000, 0b00000, 0b01100, 0b01100}},
    Glyph{'-', {0b00000, 0b00000, 0b00000, 0b11111, 0b00000, 0b00000, 0b00000}},
    Glyph{'+', {0b00000, 0b00100, 0b00100, 0b11111, 0b00100, 0b00100, 0b00000}},
    Glyph{'e', {0b00000, 0b00000, 0b01110, 0b10001, 0b11111, 0b10000, 0b01110}},
};

constexpr int kAdvancePx = kGlyphWidthPx + 1;

void fill_dot(Image& image, int left, int top, int zoom, float value) {
  for (int y = top; y < top + zoom; ++y)
    for (int x = left; x < left + zoom; ++x) {
      if (x < 0 || y < 0 || x >= image.width || y >= image.height) continue;
      for (std::size_t c = 0; c < image.channel_count(); ++c) image.at(x, y, c) = value;
    }
}

void draw_glyph(Image& image, int x, int y, const Glyph& glyph, int zoom, float value) {
  for (int row = 0; row < kGlyphHeightPx; ++row)
    for (int column = 0; column < kGlyphWidthPx; ++column)
      if ((nth(glyph.rows, row) >> (kGlyphWidthPx - 1 - column) & 1) != 0)
        fill_dot(image, x + column * zoom, y + row * zoom, zoom, value);
}

void set_pixel(Image& image, int x, int y, Rgb colour) {
  std::copy(colour.begin(), colour.end(), &image.at(x, y, 0));
}

// All lengths in pixels; they grow with the image, so that the digits of a large one stay readable when it
// is shown small.
struct Layout {
  int zoom;
  int height;
  int bar_left;
  int bar_right;
  int text_left;
};

Layout layout_of(const Image& map) {
  constexpr int kHeightPerZoom = 256;
  const int zoom = std::max(1, map.height / kHeightPerZoom);
  constexpr int kLinesOfText = 3;
  const int bar_left = map.width + 6 * zoom;
  const int bar_right = bar_left + 12 * zoom;
  return {zoom, std::max(map.height, kLinesOfText * (kGlyphHeightPx + 2) * zoom), bar_left, bar_right,
          bar_right + 3 * zoom};
}

struct Label {
  std::string text;
  double height_share;  // 0 at the bottom of the bar, 1 at its top
};

std::vector<Label> labels_of(ColourScale scale, float maximum) {
  const auto top = fmt::format("{:.3g}", maximum);
  switch (scale) {
    case ColourScale::Sequential:
      return {{"0", 0.0}, {top, 1.0}};
    case ColourScale::Diverging:
      return {{"-" + top, 0.0}, {"0", 0.5}, {"+" + top, 1.0}};
  }
  return {};
}

void draw_scale_bar(Image& image, const Layout& layout, const Colouring& colouring) {
  const float bottom = colouring.scale == ColourScale::Diverging ? -colouring.maximum : 0.0F;
  for (int y = 0; y < layout.height; ++y) {
    const float share = 1.0F - static_cast<float>(y) / static_cast<float>(layout.height - 1);
    const Rgb colour = colouring(bottom + share * (colouring.maximum - bottom));
    for (int x = layout.bar_left; x < layout.bar_right; ++x) set_pixel(image, x, y, colour);
  }
  constexpr float kInk = 0.9F;
  for (const Label& label : labels_of(colouring.scale, colouring.maximum)) {
    const int room = layout.height - kGlyphHeightPx * layout.zoom;
    const int top = static_cast<int>(std::lround((1.0 - label.height_share) * room));
    draw_text(image, layout.text_left, top, label.text, layout.zoom, kInk);
  }
}

}  // namespace

int text_width_px(std::string_view text, int zoom) {
  if (text.empty()) return 0;
  return zoom * (static_cast<int>(text.size()) * kAdvancePx - 1);
}

void draw_text(Image& image, int x, int y, std::string_view text, int zoom, float value) {
  for (const char character : text) {
    for (const Glyph& glyph : kGlyphs)
      if (glyph.character == character) draw_glyph(image, x, y, glyph, zoom, value);
    x += kAdvancePx * zoom;
  }
}

std::array<float, 3> colour_at(ColourScale scale, float position) {
  if (std::isnan(position)) return kNoValue;
  const double t = position;
  const auto linear = linear_rgb(scale == ColourScale::Sequential ? sequential(std::clamp(t, 0.0, 1.0))
                                                                  : diverging(std::clamp(t, -1.0, 1.0)));
  Rgb encoded{};
  for (std::size_t c = 0; c < 3; ++c) encoded[c] = srgb_encode(static_cast<float>(linear[c]));
  return encoded;
}

float largest_magnitude(const Image& map) {
  float largest = 0.0F;
  for (const float value : map.pixels)
    if (std::isfinite(value)) largest = std::max(largest, std::fabs(value));
  return largest;
}

Image false_colour(const Image& map, ColourScale scale, float maximum) {
  const std::size_t channels = map.channel_count();
  if (channels != 1 && channels != 3)
    throw InputError(fmt::format("a map to colour has {} channels, expected 1 or 3", channels));
  if (!std::isfinite(maximum) || maximum < 0.0F)
    throw InputError(
        fmt::format("the end of a colour scale is {}, expected a finite number from 0 on", maximum));
  const Layout layout = layout_of(map);
  const Colouring colouring{scale, maximum, colour_table(scale)};
  int text_width = 0;
  for (const Label& label : labels_of(scale, maximum))
    text_width = std::max(text_width, text_width_px(label.text, layout.zoom));
  Image image = make_image(layout.text_left + text_width + 3 * layout.zoom, layout.height, {"R", "G", "B"});
  for (int y = 0; y < map.height; ++y)
    for (int x = 0; x < map.width; ++x)
      set_pixel(image, x, y, colouring(signed_largest(&map.at(x, y, 0), channels)));
  draw_scale_bar(image, layout, colouring);
  return image;
}

}  // namespace orbs::image
