#pragma once

#include "image/image.h"

#include <array>
#include <string_view>

namespace orbs::image {

/// Sequential: 0 (black-violet) over red and orange to the maximum (pale yellow), lightness even in the
/// value. Diverging: -maximum (blue) over 0 (black) to +maximum (orange), equal magnitudes equally light.
enum class ColourScale { Sequential, Diverging };

/// Display-encoded RGB at `position`: [0, 1] on the sequential scale, [-1, 1] on the diverging one; positions
/// beyond the ends have the end's colour, NaN is mid-grey, which is no colour of either scale.
std::array<float, 3> colour_at(ColourScale scale, float position);

/// Largest finite |value| of all channels, 0 when there is none: a maximum for false_colour that cuts nothing
/// off.
float largest_magnitude(const Image& map);

/// Image for write_png: the map in colours at the left, unchanged in size, and beside it a bar of the
/// linear scale from 0 (diverging: -maximum) to `maximum` with these numbers as digits. A map of three
/// channels shows at each pixel the channel of largest magnitude, sign kept, so that nothing cancels. With
/// maximum 0 every finite pixel has the colour of 0. InputError when the map has neither one nor three
/// channels or the maximum is negative or not finite.
Image false_colour(const Image& map, ColourScale scale, float maximum);

constexpr int kGlyphWidthPx = 5;
constexpr int kGlyphHeightPx = 7;

/// Width of draw_text's result: glyphs of five pixels with one pixel between them, all times `zoom`.
int text_width_px(std::string_view text, int zoom);

/// Draws `text` with its upper left corner at (x, y), each dot of a glyph zoom x zoom pixels, in every
/// channel with `value`; what lies outside the image is cut off. Known are the characters of numbers,
/// "0123456789.-+e"; others leave a gap of one glyph.
void draw_text(Image& image, int x, int y, std::string_view text, int zoom, float value);

}  // namespace orbs::image
