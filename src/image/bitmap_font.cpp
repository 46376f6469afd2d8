#include "image/bitmap_font.h"

#include <array>
#include <cstdint>

namespace orbs::image {

namespace {

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
      if ((glyph.rows[static_cast<std::size_t>(row)] >> (kGlyphWidthPx - 1 - column) & 1) != 0)
        fill_dot(image, x + column * zoom, y + row * zoom, zoom, value);
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

}  // namespace orbs::image
