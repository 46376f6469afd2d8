#include "studies/qualify/control_image.h"

#include "base/error.h"
#include "image/image_io.h"

#include <filesystem>

#include <fmt/format.h>

namespace orbs::studies {

image::Image control_image(const results::RunRecord& run,
                           const std::string& renderer,
                           const std::string& case_name,
                           const std::string& target) {
  for (const auto& one : run.targets) {
    if (one.renderer != renderer || one.case_name != case_name || one.target != target) continue;
    if (one.image.empty())
      throw InputError(fmt::format("{} has no image in {}: {}", renderer, run.folder, one.reason));
    return image::read_image(std::filesystem::path(run.folder) / one.image);
  }
  throw InputError(fmt::format("{} holds no image of it by {}", run.folder, renderer));
}

}  // namespace orbs::studies
