#include "report/page_file.h"

#include "base/error.h"
#include "base/files.h"
#include "base/files_inside.h"
#include "image/colour.h"
#include "image/image_io.h"
#include "json/writer.h"
#include "report/overview.h"
#include "report/packed_image.h"
#include "report/target_data.h"
#include "results/study_kinds.h"

#include <set>

#include <fmt/format.h>

namespace orbs::report {

std::string file_of(const std::filesystem::path& folder, const std::string& name) {
  const auto file = open_inside(folder, name);
  if (!file) throw InputError(fmt::format("{}: there is no such file in {}", name, folder.string()));
  return file->read(0, static_cast<std::size_t>(file->size()));
}

EmbeddedImages embed_images(const std::vector<std::string>& files,
                            const std::string& type,
                            const std::function<std::string(const std::string&)>& content,
                            std::size_t most_bytes) {
  EmbeddedImages embedded;
  std::set<std::string> seen;
  std::size_t used = 0;
  json::Writer names;
  names.begin_object();
  for (const auto& file : files) {
    if (file.empty() || !seen.insert(file).second) continue;
    try {
      const auto bytes = base64(content(file));
      if (used + bytes.size() > most_bytes) {
        embedded.left_out.push_back(file);
        continue;
      }
      used += bytes.size();
      const auto id = fmt::format("image-{}", embedded.count++);
      names.member(file, id);
      embedded.elements += data_element(id, type + ";base64", bytes);
    } catch (const InputError& e) {
      embedded.left_out.emplace_back(e.what());
    }
  }
  embedded.elements +=
      data_element("orbs-images", "application/json", script_text(names.end_object().text()));
  return embedded;
}

std::pair<std::string, std::string> page_template(const std::filesystem::path& bundle) {
  constexpr std::string_view kMark = "<!--orbs-data-->";
  const auto file = bundle / "single.html";
  if (!std::filesystem::exists(file))
    throw InputError(
        fmt::format("{}: is missing: the results page has not been built; './bootstrap build' makes it "
                    "and says what it needs (Node.js 18 or newer and npm)",
                    file.string()));
  const auto text = read_file(file);
  const auto at = text.find(kMark);
  if (at == std::string::npos)
    throw InputError(fmt::format("{}: has no {}; build it again", file.string(), kMark));
  return {text.substr(0, at), text.substr(at + kMark.size())};
}

std::string script_text(std::string_view json) {
  std::string out;
  out.reserve(json.size());
  for (const char c : json) {
    if (c == '<') {
      out += "\\u003c";
    } else {
      out += c;
    }
  }
  return out;
}

std::string data_element(const std::string& id, const std::string& type, const std::string& content) {
  return fmt::format("<script type=\"{}\" id=\"{}\">{}</script>\n", type, id, content);
}

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

// The file as PNG: an EXR as a display shows it, a PNG as it is.
std::string png_of(const std::filesystem::path& folder, const std::string& name) {
  auto bytes = file_of(folder, name);
  if (!name.ends_with(".exr")) return bytes;
  return image::png_bytes(image::display_image(image::read_exr(name, bytes)));
}

PageFile page_with(const PageFileSettings& settings, const std::string& data, EmbeddedImages images) {
  const auto [before, after] = page_template(settings.bundle);
  return {before + data + images.elements + after, images.count, std::move(images.left_out)};
}

}  // namespace

PageFile page_file(const RunView& view, const PageFileSettings& settings) {
  std::string targets = "[";
  for (std::size_t i = 0; i < view.run.targets.size(); ++i)
    targets += (i == 0 ? "" : ",\n") + target_json(view, i);
  const auto rounding = settings.exact ? Rounding::Exact : Rounding::Rounded;
  const auto packed = [&](const std::string& file) {
    return packed_image(image::read_exr(file, file_of(view.run.folder, file)), "", rounding, Packing::Small);
  };
  return page_with(
      settings,
      data_element("orbs-overview", "application/json", script_text(overview_json(view))) +
          data_element("orbs-targets", "application/json", script_text(targets + "]")),
      embed_images(wanted_images(view), "application/octet-stream", packed, settings.most_bytes));
}

PageFile study_page_file(const std::filesystem::path& folder, const PageFileSettings& settings) {
  const auto study = results::read_study_folder(folder);
  json::Writer about;
  about.begin_object()
      .member("name", std::filesystem::weakly_canonical(folder).filename().string())
      .member("kind", study.kind.name)
      .end_object();
  return page_with(
      settings,
      data_element("orbs-about", "application/json", script_text(about.text())) +
          data_element("orbs-study", "application/json", script_text(read_file(folder / study.kind.file))),
      embed_images(
          study.images, "image/png", [&](const std::string& file) { return png_of(folder, file); },
          settings.most_bytes));
}

}  // namespace orbs::report
