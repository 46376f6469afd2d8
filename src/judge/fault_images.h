#pragma once

#include "image/image.h"

#include <array>
#include <functional>

/// Images with R, G and B changed as faults change them. Beyond its edge an image continues as its edge
/// pixels.
namespace orbs::judge {

/// The image moved by (dx, dy) px to the right and down, between pixels by the cubic of Catmull and Rom
/// (1974) or linearly.
enum class Between { Linear, Cubic };
image::Image moved_by(const image::Image& image, double dx_px, double dy_px, Between between);

/// Each pixel is that at from(x, y), which must lie in the image.
image::Image rearranged(const image::Image& image,
                        const std::function<std::array<int, 2>(int x, int y)>& from);

/// map(value) of each value of all channels.
image::Image mapped(const image::Image& image, const std::function<float(float)>& map);

/// Filtered by a Gaussian of this standard deviation, cut at three of them.
image::Image gaussian_blurred(const image::Image& image, double sigma_px);

/// Filtered by the mean over side x side px; the side is odd.
image::Image box_blurred(const image::Image& image, int side_px);

/// The means of squares of side x side px in place of their pixels, those that there are at the edges.
image::Image in_squares(const image::Image& image, int side_px);

/// Magnified about the centre, linearly between pixels.
image::Image magnified(const image::Image& image, double factor);

}  // namespace orbs::judge
