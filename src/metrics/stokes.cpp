#include "metrics/stokes.h"

#include "image/colour.h"
#include "metrics/describe.h"

#include <cmath>
#include <vector>

#include <fmt/format.h>

namespace orbs::metrics {

double luminance_at(const std::vector<float>& rgb, std::size_t pixel) {
  return image::luminance(static_cast<double>(rgb[3 * pixel]), static_cast<double>(rgb[3 * pixel + 1]),
                          static_cast<double>(rgb[3 * pixel + 2]));
}

namespace {

// Mean square of the block means of a - b, weighted by their counted pixels.
double mean_square_of_blocks(const PairSamples& samples,
                             const std::vector<float>& a,
                             const std::vector<float>& b) {
  double squares = 0;
  for (const Rectangle& block : blocks_of(samples)) {
    double sum = 0;
    double count = 0;
    for_each_block_pixel(samples, block, [&](std::size_t pixel) {
      sum += luminance_at(a, pixel) - luminance_at(b, pixel);
      ++count;
    });
    if (count > 0) squares += sum * sum / count;
  }
  return squares / static_cast<double>(samples.included_count);
}

}  // namespace

std::optional<double> stokes_error(const PairSamples& samples) {
  if (!samples.result_stokes || !samples.reference_stokes) return std::nullopt;
  double light = 0;
  for (std::size_t pixel = 0; pixel < samples.pixel_count(); ++pixel)
    if (samples.included[pixel] != 0) light += luminance_at(samples.reference, pixel);
  if (!(light > 0)) return std::nullopt;
  const auto& result = *samples.result_stokes;
  const auto& reference = *samples.reference_stokes;
  double squares = 0;
  for (std::size_t i = 0; i < result.size(); ++i)
    squares +=
        mean_square_of_blocks(samples, result.at(i), reference.at(i)) / static_cast<double>(result.size());
  return std::sqrt(squares) / (light / static_cast<double>(samples.included_count));
}

MetricResult compute_stokes_error(const ImagePair& pair) {
  MetricResult result{stokes_error(pair)};
  if (!pair.reference_stokes)
    result.absence = Absence::NothingInReference;
  else if (!pair.result_stokes)
    result.absence = Absence::MissingInResult;
  return result;
}

std::string describe_stokes_error(const Measurement& measurement, const Limits& limits) {
  if (!measurement.value && measurement.absence == Absence::NothingInReference)
    return "the reference has no Stokes parameters to be compared with";
  if (!measurement.value && measurement.absence == Absence::MissingInResult)
    return "it has no Stokes parameters (layers S1, S2 and S3), which the scene asks for";
  if (!measurement.value) return "stokes_error has no value for this image: the reference is black";
  constexpr double kPercent = 100;
  return fmt::format("its Stokes parameters are off by {:.3g} % of the light, {}",
                     kPercent * *measurement.value, limits_text(limits, kPercent, " %"));
}

}  // namespace orbs::metrics
