#include "judge/maps.h"

#include "image/colour.h"
#include "image/false_colour.h"
#include "image/image_io.h"

#include <fmt/format.h>

namespace orbs::judge {

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
