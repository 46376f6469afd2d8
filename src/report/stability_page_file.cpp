#include "report/stability_page_file.h"

#include "base/files.h"
#include "json/writer.h"
#include "report/embedded_images.h"
#include "report/page_template.h"
#include "results/stability_study.h"

namespace orbs::report {

PageFile stability_page_file(const std::filesystem::path& folder, const PageFileSettings& settings) {
  const auto [before, after] = page_template(settings.bundle);
  PageFile page;
  page.text = before;
  const auto name = std::filesystem::weakly_canonical(folder).filename().string();
  page.text += data_element("orbs-stability-name", "application/json", script_text(json::json_string(name)));
  page.text += data_element("orbs-stability", "application/json",
                            script_text(read_file(folder / results::kStabilityFile)));
  auto images = embed_images(
      results::read_stability_folder(folder).images, "image/png",
      [&](const std::string& file) { return file_of(folder, file); }, settings.most_bytes);
  page.text += images.elements;
  page.images = images.count;
  page.left_out = std::move(images.left_out);
  page.text += after;
  return page;
}

}  // namespace orbs::report
