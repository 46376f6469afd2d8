#include "judge/difference.h"

#include "base/text.h"
#include "image/colour.h"
#include "image/false_colour.h"
#include "image/image_io.h"
#include "judge/provenance.h"
#include "metrics/seeds.h"

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

#include <fmt/format.h>

namespace orbs::judge {

namespace {

// As far as their provenance records say; only the built-in renderer writes them.
bool have_same_samples(const image::Image& a, const image::Image& b) {
  auto of_a = provenance_of(a);
  auto of_b = provenance_of(b);
  const auto is_same = [&](const char* key) { return of_a[key] == of_b[key]; };
  return !of_a["seed"].empty() && is_same("program") && is_same("spp") && is_same("seed") &&
         is_same("settings");  // of the passes of a reference; an image of one pass has none
}

// What is missing in either of them is missing in their difference.
void add_counter(const char* attribute, const image::Image& minus, image::Image& out) {
  const auto more = minus.attributes.find(attribute);
  if (more == minus.attributes.end()) return;
  auto& text = out.attributes[attribute];
  const auto of_out = to_integer(text.empty() ? "0" : text);
  const auto of_minus = to_integer(more->second);
  // What is no number stays for the check to complain of.
  text = of_out && of_minus ? std::to_string(*of_out + *of_minus) : of_out ? more->second : text;
}

}  // namespace

image::Image difference_of(const image::Image& of, const image::Image& minus) {
  const bool has_variance =
      image::channel_index(of, "variance.R") >= 0 && image::channel_index(minus, "variance.R") >= 0;
  std::vector<std::string> channels{"R", "G", "B"};
  if (has_variance) channels.insert(channels.end(), {"variance.R", "variance.G", "variance.B"});
  auto out = image::make_image(of.width, of.height, channels);
  out.attributes = of.attributes;
  for (const char* attribute : metrics::kCounters) add_counter(attribute, minus, out);
  const auto put = [&](const std::string& prefix, std::size_t first, const auto& combine) {
    const auto a = image::select_rgb(of, prefix);
    const auto b = image::select_rgb(minus, prefix);
    for (std::size_t pixel = 0; pixel < out.pixel_count(); ++pixel)
      for (std::size_t c = 0; c < 3; ++c)
        out.pixels[pixel * channels.size() + first + c] =
            combine(a.pixels[3 * pixel + c], b.pixels[3 * pixel + c]);
  };
  put("", 0, std::minus<>());
  if (has_variance && have_same_samples(of, minus))
    put("variance.", 3, [](float a, float b) { return std::max(a - b, 0.0F); });
  else if (has_variance)
    put("variance.", 3, std::plus<>());
  return out;
}

std::vector<results::MapRecord> write_maps(const image::Image& result,
                                           const metrics::Comparison& comparison,
                                           const std::filesystem::path& folder) {
  image::write_png(image::display_image(result), folder / "result.png");
  std::vector<results::MapRecord> maps;
  for (const auto& map : comparison.maps) {
    const auto stem = fmt::format("error-{}", map.info.name);
    const auto scale = map.info.is_signed ? image::ColourScale::Diverging : image::ColourScale::Sequential;
    image::write_exr(map.image, folder / (stem + ".exr"));
    image::write_png(image::false_colour(map.image, scale, map.info.scale_maximum), folder / (stem + ".png"));
    maps.push_back({std::string(map.info.name), stem + ".exr", std::string(map.info.definition),
                    map.info.is_signed, static_cast<double>(map.info.scale_maximum)});
  }
  return maps;
}

}  // namespace orbs::judge
