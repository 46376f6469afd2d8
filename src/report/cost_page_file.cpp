#include "report/cost_page_file.h"

#include "base/error.h"
#include "base/files.h"
#include "base/files_inside.h"
#include "base/scratch_folder.h"
#include "image/colour.h"
#include "image/image_io.h"
#include "json/writer.h"
#include "report/gzip.h"
#include "report/page_template.h"
#include "results/cost_study.h"

#include <set>

#include <fmt/format.h>

namespace orbs::report {

namespace {

namespace fs = std::filesystem;

// The contents of a file of the study. InputError if it does not lie in the study's folder, whatever
// cost.json says.
std::string file_of(const fs::path& folder, const std::string& name) {
  const auto file = open_inside(folder, name);
  if (!file) throw InputError(fmt::format("{}: there is no such file in the folder of the study", name));
  return file->read(0, static_cast<std::size_t>(file->size()));
}

// The file as PNG: an EXR as a display shows it, a PNG as it is.
std::string png_of(const fs::path& folder, const std::string& name, const fs::path& scratch) {
  auto bytes = file_of(folder, name);
  if (!name.ends_with(".exr")) return bytes;
  const auto png = scratch / "shown.png";
  image::write_png(image::display_image(image::read_exr(name, bytes)), png);
  return read_file(png);
}

// Puts images into `page` while there is room. Returns which file became which element.
std::string add_images(const fs::path& folder, const PageFileSettings& settings, PageFile& page) {
  const auto images = results::read_cost_study(folder).images;
  auto wanted = images.references;
  wanted.insert(wanted.end(), images.points.begin(), images.points.end());
  const ScratchFolder scratch("orbs-report");
  std::set<std::string> seen;
  std::size_t used = 0;
  json::Writer names;
  names.begin_object();
  for (const auto& file : wanted) {
    if (!seen.insert(file).second) continue;
    try {
      const auto bytes = base64(png_of(folder, file, scratch.path()));
      if (used + bytes.size() > settings.most_bytes) {
        page.left_out.push_back(file);
        continue;
      }
      used += bytes.size();
      const auto id = fmt::format("image-{}", page.images++);
      names.member(file, id);
      page.text += data_element(id, "image/png;base64", bytes);
    } catch (const InputError& e) {
      page.left_out.emplace_back(e.what());
    }
  }
  return names.end_object().text();
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
  const auto names = add_images(folder, settings, page);
  page.text += data_element("orbs-images", "application/json", script_text(names));
  page.text += after;
  return page;
}

}  // namespace orbs::report
