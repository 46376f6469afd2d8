#include "results/study_kinds.h"

#include "base/error.h"
#include "json/document.h"
#include "json/field_reader.h"
#include "json/object_reader.h"

#include <algorithm>

#include <fmt/format.h>

namespace orbs::results {

namespace fs = std::filesystem;

// References first, for an image says little without what it should be; then the images that somebody would
// wait for.
std::vector<std::string> cost_images(json::ObjectReader& root) {
  std::vector<std::string> files;
  for (auto& target : root.objects("targets")) files.push_back(target.text_or("reference", ""));
  std::vector<std::vector<std::string>> curves;
  std::size_t longest = 0;
  for (auto& curve : root.objects("curves")) {
    auto& images = curves.emplace_back();
    for (auto& point : curve.objects("points")) images.push_back(point.text_or("image", ""));
    longest = std::max(longest, images.size());
  }
  for (std::size_t back = 1; back <= longest; ++back)
    for (const auto& curve : curves)
      if (back <= curve.size()) files.push_back(curve[curve.size() - back]);
  std::erase(files, "");
  return files;
}

std::vector<std::string> stability_images(json::ObjectReader& root) {
  std::vector<std::string> files;
  for (auto& step : root.objects("steps"))
    if (const auto images = step.text_or("images", ""); !images.empty())
      for (const char* name : {kOriginalImage, kChangedImage, kDifferenceImage})
        files.push_back(images + "/" + name);
  return files;
}

const StudyKind* study_kind_in(const fs::path& folder) {
  std::error_code ignored;  // a folder of somebody else, a link that leads to itself
  const auto* const kind = std::find_if(kStudyKinds.begin(), kStudyKinds.end(), [&](const StudyKind& one) {
    return fs::exists(folder / one.file, ignored);
  });
  return kind == kStudyKinds.end() ? nullptr : kind;
}

StudyFolder read_study_folder(const fs::path& folder) {
  const auto* const kind = study_kind_in(folder);
  if (kind == nullptr)
    throw InputError(fmt::format(
        "{}: holds no study; name a folder that 'orbs cost' or 'orbs stability' made", folder.string()));
  const auto document = json::parse_file(folder / kind->file);
  json::ObjectReader root(document);
  json::check_format(root, kind->format);
  auto started = root.text_or("started", "");
  return {*kind, std::move(started), kind->images(root)};
}

}  // namespace orbs::results
