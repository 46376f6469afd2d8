#include "cli/compare/compare_images.h"

#include "base/error.h"
#include "cli/compare/chosen_channels.h"
#include "image/colour.h"
#include "image/image_io.h"
#include "judge/noise.h"
#include "metrics/describe.h"
#include "metrics/image_pair.h"

#include <fmt/format.h>

namespace orbs::cli {

namespace {

// Images for the screen hold sRGB values; the metrics are defined on linear ones.
image::Image read_linear(const std::string& file) {
  auto image = image::read_image(file);
  if (image::is_ldr_file(file))
    for (auto& value : image.pixels) value = image::srgb_decode(value);
  return image;
}

// Noise and bias would be numbers that mean nothing.
void check_variances(const image::Image& image, const std::string& file) {
  if (const auto problem = judge::variance_problem(image); !problem.empty())
    throw InputError(
        fmt::format("{}: {}, so noise cannot be told from bias; mend these channels, or leave out all of "
                    "variance.R, G and B",
                    file, problem));
}

}  // namespace

ComparedImages compare_images(const std::string& first,
                              const std::string& second,
                              const CompareOptions& options) {
  ComparedImages compared{read_linear(first), read_linear(second), {}, {}, {}};
  const auto whole = compared.first;  // before its channels are renamed
  for (auto sentence : {choose_channels(compared.first, compared.second, options.channels, first),
                        choose_channels(compared.second, whole, options.channels, second)})
    if (!sentence.empty()) compared.remarks.push_back(std::move(sentence));
  check_variances(compared.first, first);
  check_variances(compared.second, second);
  const auto alignment =
      metrics::check_alignment(compared.first, compared.second, metrics::NegativePixels::Allowed);
  if (alignment.alignment != metrics::Alignment::Comparable)
    throw InputError(fmt::format("{} (the result) and {} (the reference) cannot be compared: {}", first,
                                 second, alignment.reason));
  const auto pair = metrics::make_image_pair(compared.first, compared.second, {}, {.threads = 0});
  metrics::MetricSelection selection{.all = options.all};
  if (!options.metric.empty()) selection.also = {options.metric};
  compared.comparison = metrics::compare(pair, selection);
  compared.channels = metrics::channel_differences(compared.first, compared.second);
  const auto bias = metrics::bias_remarks(pair.noise);
  compared.remarks.insert(compared.remarks.end(), bias.begin(), bias.end());
  return compared;
}

bool is_beyond(const CompareOptions& options, const std::optional<double>& value) {
  if (!options.min && !options.max) return false;
  return !value || (options.min && !(*value >= *options.min)) || (options.max && !(*value <= *options.max));
}

std::string tolerance_text(const CompareOptions& options) {
  return fmt::format("beyond the tolerance: {}{}{}", options.metric,
                     options.min ? fmt::format(", at least {} is needed", *options.min) : "",
                     options.max ? fmt::format(", at most {} is allowed", *options.max) : "");
}

}  // namespace orbs::cli
