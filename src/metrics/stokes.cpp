#include "metrics/stokes.h"

#include "image/colour.h"
#include "metrics/noise_test.h"

#include <algorithm>
#include <cmath>

namespace orbs::metrics {

namespace {

double luminance_of(const image::Image& rgb, std::size_t pixel) {
  return image::luminance(static_cast<double>(rgb.pixels[3 * pixel]),
                          static_cast<double>(rgb.pixels[3 * pixel + 1]),
                          static_cast<double>(rgb.pixels[3 * pixel + 2]));
}

// Mean square of the block means of a - b, weighted by their counted pixels.
double mean_square_of_blocks(const image::Image& a,
                             const image::Image& b,
                             const std::vector<std::uint8_t>& included) {
  double squares = 0;
  double counted = 0;
  for (int y0 = 0; y0 < a.height; y0 += kBlock_px)
    for (int x0 = 0; x0 < a.width; x0 += kBlock_px) {
      double sum = 0;
      double count = 0;
      for (int y = y0; y < std::min(y0 + kBlock_px, a.height); ++y)
        for (int x = x0; x < std::min(x0 + kBlock_px, a.width); ++x) {
          const auto pixel =
              static_cast<std::size_t>(y) * static_cast<std::size_t>(a.width) + static_cast<std::size_t>(x);
          if (included[pixel] == 0) continue;
          sum += luminance_of(a, pixel) - luminance_of(b, pixel);
          ++count;
        }
      if (count > 0) squares += sum * sum / count;
      counted += count;
    }
  return counted > 0 ? squares / counted : 0;
}

}  // namespace

bool has_stokes(const image::Image& image) {
  return std::all_of(kStokesLayers.begin(), kStokesLayers.end(), [&](const char* layer) {
    return image::channel_index(image, std::string(layer) + "R") >= 0;
  });
}

std::optional<double> stokes_error(const image::Image& result,
                                   const image::Image& reference,
                                   const Mask& mask) {
  if (!has_stokes(result) || !has_stokes(reference)) return std::nullopt;
  const auto included = included_pixels(mask, reference.width, reference.height);
  const auto colour = image::select_rgb(reference, "");
  double light = 0;
  double counted = 0;
  for (std::size_t pixel = 0; pixel < reference.pixel_count(); ++pixel) {
    if (included[pixel] == 0) continue;
    light += luminance_of(colour, pixel);
    ++counted;
  }
  if (!(light > 0)) return std::nullopt;
  double squares = 0;
  for (const char* layer : kStokesLayers)
    squares += mean_square_of_blocks(image::select_rgb(result, layer), image::select_rgb(reference, layer),
                                     included) /
               static_cast<double>(kStokesLayers.size());
  return std::sqrt(squares) / (light / counted);
}

}  // namespace orbs::metrics
