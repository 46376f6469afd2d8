#include "metrics/seeds.h"

#include "base/error.h"
#include "base/text.h"

#include <algorithm>
#include <map>
#include <optional>
#include <string>

#include <fmt/format.h>

namespace orbs::metrics {

namespace {

double mean_at(const std::vector<image::Image>& colours, std::size_t sample) {
  double sum = 0;
  for (const auto& colour : colours) sum += static_cast<double>(colour.pixels[sample]);
  return sum / static_cast<double>(colours.size());
}

void check_seeds(const std::vector<image::Image>& colours) {
  if (colours.size() < 2)
    throw InputError(
        fmt::format("the noise of {} render cannot be known; two seeds are needed", colours.size()));
  const auto& first = colours.front();
  for (const auto& colour : colours)
    if (colour.width != first.width || colour.height != first.height)
      throw InputError(fmt::format("renders of one scene differ in size: {} x {} px and {} x {} px",
                                   first.width, first.height, colour.width, colour.height));
  if (are_equal(colours))
    throw InputError(
        "renders with different seeds are equal to the bit: the renderer ignores its seed, or the scene "
        "has no noise");
}

// Those of one render are not those of their mean: it has the samples of all of them, where each says how
// many these are.
void take_sample_counts(const std::vector<image::Image>& images,
                        std::map<std::string, std::string>& attributes) {
  for (const char* name : {"orbs.spp", "orbs.bad_samples"}) {
    long long sum = 0;
    bool is_known = true;
    for (const auto& image : images) {
      const auto stated = image.attributes.find(name);
      const auto count = stated == image.attributes.end() ? std::nullopt : to_integer(stated->second);
      is_known = is_known && count;
      sum += count.value_or(0);
    }
    attributes.erase(name);
    if (is_known) attributes[name] = std::to_string(sum);
  }
}

}  // namespace

bool are_equal(const std::vector<image::Image>& images) {
  return std::all_of(images.begin(), images.end(),
                     [&](const auto& image) { return image::has_same_colours(image, images.front()); });
}

image::Image mean_of(const std::vector<image::Image>& images) {
  const auto colours = image::colours_of(images);
  auto mean = image::make_image(colours.front().width, colours.front().height, {"R", "G", "B"});
  for (std::size_t i = 0; i < mean.pixels.size(); ++i)
    mean.pixels[i] = static_cast<float>(mean_at(colours, i));
  return mean;
}

image::Image mean_and_variance_of(const std::vector<image::Image>& images) {
  const auto colours = image::colours_of(images);
  check_seeds(colours);
  const auto count = static_cast<double>(colours.size());
  auto out = image::make_image(colours.front().width, colours.front().height,
                               {"R", "G", "B", "variance.R", "variance.G", "variance.B"});
  out.attributes = images.front().attributes;
  take_sample_counts(images, out.attributes);
  for (std::size_t i = 0; i < colours.front().pixels.size(); ++i) {
    const double mean = mean_at(colours, i);
    double squares = 0;
    for (const auto& colour : colours) {
      const double difference = static_cast<double>(colour.pixels[i]) - mean;
      squares += difference * difference;
    }
    const std::size_t at = i / 3 * 6 + i % 3;
    out.pixels[at] = static_cast<float>(mean);
    out.pixels[at + 3] = static_cast<float>(squares / (count - 1) / count);
  }
  return out;
}

}  // namespace orbs::metrics
