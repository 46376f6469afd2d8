#include "studies/probe/noise.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace orbs::studies {

double noise_tolerance(const image::Image& image,
                       const std::vector<Pixel>& pixels,
                       std::string_view channels) {
  constexpr double kDeviations = 8;
  if (pixels.empty()) return 0;
  double most = 0;
  for (const char name : channels) {
    const int channel = image::channel_index(image, fmt::format("variance.{}", name));
    if (channel < 0) return 0;
    std::vector<float> variances;
    for (const Pixel& pixel : pixels)
      variances.push_back(image.at(pixel.x, pixel.y, static_cast<std::size_t>(channel)));
    const auto median = variances.begin() + std::ssize(variances) / 2;
    std::nth_element(variances.begin(), median, variances.end());
    most = std::max(most, std::sqrt(static_cast<double>(*median)));
  }
  return kDeviations * most;
}

}  // namespace orbs::studies
