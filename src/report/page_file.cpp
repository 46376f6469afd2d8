#include "report/page_file.h"

#include "image/image_io.h"
#include "report/embedded_images.h"
#include "report/gzip.h"
#include "report/overview.h"
#include "report/packed_image.h"
#include "report/page_template.h"
#include "report/target_data.h"

namespace orbs::report {

namespace {

using results::RunView;

// The image files of the run that the page shows, the most useful ones first. Maps are in runs of earlier
// versions; the page computes them.
std::vector<std::string> wanted_images(const RunView& view) {
  std::vector<std::string> files;
  for (const bool maps : {false, true})
    for (const bool failures : {true, false})
      for (const auto& target : view.run.targets) {
        if (results::counts_as_failure(target.verdict, target.expectation) != failures) continue;
        if (!maps) {
          files.push_back(target.image);
          files.push_back(target.reference_image);
        } else {
          for (const auto& map : target.maps) files.push_back(map.image);
        }
      }
  return files;
}

}  // namespace

PageFile page_file(const RunView& view, const PageFileSettings& settings) {
  const auto [before, after] = page_template(settings.bundle);
  PageFile page;
  page.text = before;
  page.text += data_element("orbs-overview", "application/json", script_text(overview_json(view)));
  std::string targets = "[";
  for (std::size_t i = 0; i < view.run.targets.size(); ++i)
    targets += (i == 0 ? "" : ",\n") + target_json(view, i);
  page.text += data_element("orbs-targets", "application/json", script_text(targets + "]"));
  const auto rounding = settings.exact ? Rounding::Exact : Rounding::Rounded;
  const auto packed = [&](const std::string& file) {
    return packed_image(image::read_exr(file, file_of(view.run.folder, file)), "", rounding, Packing::Small);
  };
  auto images = embed_images(wanted_images(view), "application/octet-stream", packed, settings.most_bytes);
  page.text += images.elements;
  page.images = images.count;
  page.left_out = std::move(images.left_out);
  page.text += after;
  return page;
}

}  // namespace orbs::report
