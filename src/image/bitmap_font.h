#pragma once

#include "image/image.h"

#include <string_view>

namespace orbs::image {

constexpr int kGlyphWidthPx = 5;
constexpr int kGlyphHeightPx = 7;

/// Width of draw_text's result: glyphs of five pixels with one pixel between them, all times `zoom`.
int text_width_px(std::string_view text, int zoom);

/// Draws `text` with its upper left corner at (x, y), each dot of a glyph zoom x zoom pixels, in every
/// channel with `value`; what lies outside the image is cut off. Known are the characters of numbers,
/// "0123456789.-+e"; others leave a gap of one glyph.
void draw_text(Image& image, int x, int y, std::string_view text, int zoom, float value);

}  // namespace orbs::image
