#include "results/cost_study.h"

#include "json/document.h"
#include "json/object_reader.h"
#include "results/field_reader.h"

#include <algorithm>

namespace orbs::results {

namespace {

// The images of each curve, in the order of its rungs.
std::vector<std::vector<std::string>> images_of_curves(json::ObjectReader& root) {
  std::vector<std::vector<std::string>> curves;
  for (auto& curve : root.objects("curves")) {
    auto& images = curves.emplace_back();
    for (auto& point : curve.objects("points")) images.push_back(point.text_or("image", ""));
  }
  return curves;
}

// The last rungs of all curves, then the ones before: the images near the end of the ladder are those that
// somebody would pay for.
std::vector<std::string> last_rungs_first(const std::vector<std::vector<std::string>>& curves) {
  std::size_t longest = 0;
  for (const auto& curve : curves) longest = std::max(longest, curve.size());
  std::vector<std::string> files;
  for (std::size_t back = 1; back <= longest; ++back)
    for (const auto& curve : curves)
      if (back <= curve.size() && !curve[curve.size() - back].empty())
        files.push_back(curve[curve.size() - back]);
  return files;
}

}  // namespace

bool holds_cost_study(const std::filesystem::path& folder) {
  std::error_code ignored;
  return std::filesystem::exists(folder / kCostFile, ignored);
}

CostStudy read_cost_study(const std::filesystem::path& folder) {
  const auto document = json::parse_file(folder / kCostFile);
  json::ObjectReader root(document);
  check_format(root, kCostFormat);
  CostStudy study;
  study.started = root.text_or("started", "");
  for (auto& target : root.objects("targets"))
    if (auto file = target.text_or("reference", ""); !file.empty())
      study.images.references.push_back(std::move(file));
  study.images.points = last_rungs_first(images_of_curves(root));
  return study;
}

}  // namespace orbs::results
