#include "results/stability_study.h"

#include "json/document.h"
#include "json/object_reader.h"
#include "results/field_reader.h"

namespace orbs::results {

bool holds_stability_study(const std::filesystem::path& folder) {
  std::error_code ignored;
  return std::filesystem::exists(folder / kStabilityFile, ignored);
}

StabilityFolder read_stability_folder(const std::filesystem::path& folder) {
  const auto document = json::parse_file(folder / kStabilityFile);
  json::ObjectReader root(document);
  check_format(root, kStabilityFormat);
  StabilityFolder study;
  study.started = root.text_or("started", "");
  for (auto& step : root.objects("steps")) {
    const auto images = step.text_or("images", "");
    if (images.empty()) continue;
    for (const char* name : {kOriginalImage, kChangedImage, kDifferenceImage})
      study.images.push_back(images + "/" + name);
  }
  return study;
}

}  // namespace orbs::results
