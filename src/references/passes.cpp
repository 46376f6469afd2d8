#include "references/passes.h"

#include "base/error.h"
#include "base/text.h"

#include <algorithm>

#include <fmt/format.h>

namespace orbs::references {

void add_pass(PassSum& sum, const image::Image& image, const Pass& pass) {
  if (sum.passes.empty()) {
    sum.width = image.width;
    sum.height = image.height;
    sum.attributes = image.attributes;
  } else if (image.width != sum.width || image.height != sum.height) {
    throw InputError(fmt::format("a pass of {} x {} px cannot be added to one of {} x {} px", image.width,
                                 image.height, sum.width, sum.height));
  }
  const std::size_t count = image.channel_count();
  for (std::size_t c = 0; c < count; ++c) {
    auto& values = sum.channels[image.channels[c]];
    values.resize(image.pixel_count());
    const double weight =
        image::is_variance(image.channels[c]) ? static_cast<double>(pass.spp) * pass.spp : pass.spp;
    for (std::size_t pixel = 0; pixel < values.size(); ++pixel)
      values[pixel] += weight * static_cast<double>(image.pixels[pixel * count + c]);
  }
  sum.passes.push_back(pass);
  sum.spp += pass.spp;
  const auto bad = image.attributes.find("orbs.bad_samples");
  if (bad != image.attributes.end()) sum.bad_samples += to_integer(bad->second).value_or(0);
}

image::Image mean_image(const PassSum& sum) {
  std::vector<std::string> names{"R", "G", "B", "variance.R", "variance.G", "variance.B"};
  std::erase_if(names, [&](const auto& name) { return !sum.channels.contains(name); });
  for (const auto& [name, values] : sum.channels)
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  auto image = image::make_image(sum.width, sum.height, names);
  image.attributes = sum.attributes;
  for (std::size_t c = 0; c < names.size(); ++c) {
    const auto& values = sum.channels.at(names[c]);
    const double weight = image::is_variance(names[c]) ? static_cast<double>(sum.spp) * sum.spp : sum.spp;
    for (std::size_t pixel = 0; pixel < values.size(); ++pixel)
      image.pixels[pixel * names.size() + c] = static_cast<float>(values[pixel] / weight);
  }
  return image;
}

}  // namespace orbs::references
