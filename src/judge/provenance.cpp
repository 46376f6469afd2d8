#include "judge/provenance.h"

#include "base/files.h"

#include <algorithm>
#include <vector>

#include <fmt/format.h>

namespace orbs::judge {

std::map<std::string, std::string> provenance_of(const image::Image& image) {
  constexpr std::string_view kPrefix = "orbs.";
  std::map<std::string, std::string> provenance;
  for (const auto& [name, text] : image.attributes)
    if (name.starts_with(kPrefix)) provenance[name.substr(kPrefix.size())] = text;
  return provenance;
}

std::string image_hash(const image::Image& image) {
  auto names = image.channels;
  std::sort(names.begin(), names.end());
  auto hash = content_hash(fmt::format("{} x {}", image.width, image.height));
  std::vector<float> values(image.pixel_count());
  for (const auto& name : names) {
    const auto channel = static_cast<std::size_t>(image::channel_index(image, name));
    for (std::size_t pixel = 0; pixel < values.size(); ++pixel)
      values[pixel] = image.pixels[pixel * image.channel_count() + channel];
    hash = content_hash(name, hash);
    hash = content_hash({reinterpret_cast<const char*>(values.data()), values.size() * sizeof(float)}, hash);
  }
  return hash_text(hash);
}

}  // namespace orbs::judge
