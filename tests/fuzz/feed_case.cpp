#include "fuzz/feed.h"
#include "registry/cases.h"

namespace orbs::fuzz {

// Scenes of the case are found beside it, in the folder of a case that exists.
std::string feed_case(std::string_view bytes) {
  const std::filesystem::path file = ORBS_SOURCE_DIR "/data/cases/orbs/m1_lambert/case.json";
  return complaint_of(file.string(), [&] {
    const auto one_case = registry::parse_case(file, std::string(bytes));
    require(!one_case.scenes.empty(), "a case has a scene");
    for (const auto& gate : one_case.gates) require(gate.min || gate.max, "a gate has a limit");
    for (const auto& name : registry::target_names(one_case))
      require(!name.empty() && name.find_first_of(std::string_view("/\0", 2)) == std::string::npos,
              "a name is one of a folder");
    for (const auto& mask : one_case.masks)
      for (const auto& r : mask.rectangles) require(r.x0 < r.x1 && r.y0 < r.y1, "a rectangle holds a pixel");
  });
}

}  // namespace orbs::fuzz
