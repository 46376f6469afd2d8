#include "fuzz/feed.h"
#include "scene/lights/ies.h"

#include <cmath>

namespace orbs::fuzz {

namespace {

void check_profile(const scene::IesProfile& profile) {
  require(std::isfinite(profile.max_candela) && profile.max_candela > 0, "the peak is a number above 0");
  require(profile.horizontal_deg.front() == 0 && profile.horizontal_deg.back() == 360,
          "planes go all around");
  for (const double vertical_deg : {0.0, 1e-9, 33.0, 90.0, 179.9, 180.0})
    for (const double horizontal_deg : {-720.0, -1e-9, 0.0, 0.1, 89.5, 270.0, 359.9999, 360.0, 1e6}) {
      const double candela = scene::candela_at(profile, vertical_deg, horizontal_deg);
      require(candela >= 0 && candela <= profile.max_candela * (1 + 1e-12),
              "candela lie between 0 and the peak");
    }
}

}  // namespace

std::string feed_ies(std::string_view bytes) {
  return complaint_of("lamp.ies", [&] { check_profile(scene::parse_ies("lamp.ies", bytes)); });
}

}  // namespace orbs::fuzz
