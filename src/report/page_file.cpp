#include "report/page_file.h"

#include "base/error.h"
#include "base/files_inside.h"
#include "image/image_io.h"
#include "json/writer.h"
#include "report/gzip.h"
#include "report/overview.h"
#include "report/packed_image.h"
#include "report/page_template.h"
#include "report/target_data.h"

#include <algorithm>
#include <set>

#include <fmt/format.h>

namespace orbs::report {

namespace {

namespace fs = std::filesystem;
using results::RunView;
using results::TargetRecord;

// The image files of the run that the page shows, without repetitions, the most useful ones first.
std::vector<std::string> wanted_images(const RunView& view) {
  std::vector<std::string> files;
  std::set<std::string> seen;
  const auto add = [&](const std::string& file) {
    if (!file.empty() && seen.insert(file).second) files.push_back(file);
  };
  for (const bool failures : {true, false})
    for (const bool maps : {false, true})
      for (const auto& target : view.run.targets) {
        if (results::counts_as_failure(target.verdict) != failures) continue;
        if (!maps) {
          add(target.image);
          add(target.reference_image);
        } else {
          for (const auto& map : target.maps) add(map.image);
        }
      }
  return files;
}

// The contents of a file of the run. InputError if it does not lie in the run's folder, whatever results.json
// says.
std::string file_of(const RunView& view, const std::string& name) {
  const auto file = open_inside(view.run.folder, name);
  if (!file) throw InputError(fmt::format("{}: there is no such file in the folder of the run", name));
  return file->read(0, static_cast<std::size_t>(file->size()));
}

// Puts images into `page` while there is room. Returns which file became which element.
std::string add_images(const RunView& view, const PageFileSettings& settings, PageFile& page) {
  constexpr int kSmall = 9;
  std::size_t used = 0;
  json::Writer names;
  names.begin_object();
  for (const auto& file : wanted_images(view)) {
    try {
      const auto rounding = settings.exact ? Rounding::Exact : Rounding::Rounded;
      auto bytes = base64(packed_image(image::read_exr(file, file_of(view, file)), "", rounding, kSmall));
      if (used + bytes.size() > settings.most_bytes) {
        page.left_out.push_back(file);
        continue;
      }
      used += bytes.size();
      const auto id = fmt::format("image-{}", page.images++);
      names.member(file, id);
      page.text += data_element(id, "application/octet-stream;base64", bytes);
    } catch (const InputError& e) {
      page.left_out.emplace_back(e.what());
    }
  }
  return names.end_object().text();
}

// Thumbnails are embedded only as long as there are few of them.
void add_thumbnails(const RunView& view, PageFile& page) {
  constexpr std::size_t kMost = 200;
  const auto& targets = view.run.targets;
  std::size_t count = 0;
  for (std::size_t i = 0; i < targets.size() && count < kMost; ++i) {
    const auto name = (fs::path(targets[i].image).parent_path() / "result.png").string();
    if (targets[i].image.empty() || !open_inside(view.run.folder, name)) continue;
    page.text +=
        data_element(fmt::format("thumbnail-{}", i), "image/png;base64", base64(file_of(view, name)));
    ++count;
  }
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
  const auto names = add_images(view, settings, page);
  page.text += data_element("orbs-images", "application/json", script_text(names));
  add_thumbnails(view, page);
  page.text += after;
  return page;
}

}  // namespace orbs::report
