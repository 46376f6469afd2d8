#include "report/cost_page_file.h"

#include "base/files.h"
#include "image/colour.h"
#include "image/image_io.h"
#include "json/writer.h"
#include "report/embedded_images.h"
#include "report/page_template.h"
#include "results/cost_study.h"

namespace orbs::report {

namespace {

namespace fs = std::filesystem;

// The file as PNG: an EXR as a display shows it, a PNG as it is.
std::string png_of(const fs::path& folder, const std::string& name) {
  auto bytes = file_of(folder, name);
  if (!name.ends_with(".exr")) return bytes;
  return image::png_bytes(image::display_image(image::read_exr(name, bytes)));
}

// References first: an image says little without what it should be.
std::vector<std::string> wanted_images(const fs::path& folder) {
  const auto images = results::read_cost_study(folder).images;
  auto files = images.references;
  files.insert(files.end(), images.points.begin(), images.points.end());
  return files;
}

}  // namespace

PageFile cost_page_file(const fs::path& folder, const PageFileSettings& settings) {
  const auto [before, after] = page_template(settings.bundle);
  PageFile page;
  page.text = before;
  const auto name = fs::weakly_canonical(folder).filename().string();
  page.text += data_element("orbs-cost-name", "application/json", script_text(json::json_string(name)));
  page.text +=
      data_element("orbs-cost", "application/json", script_text(read_file(folder / results::kCostFile)));
  const auto png = [&](const std::string& file) { return png_of(folder, file); };
  auto images = embed_images(wanted_images(folder), "image/png", png, settings.most_bytes);
  page.text += images.elements;
  page.images = images.count;
  page.left_out = std::move(images.left_out);
  page.text += after;
  return page;
}

}  // namespace orbs::report
