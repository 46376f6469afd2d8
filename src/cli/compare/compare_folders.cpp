#include "cli/compare/compare_folders.h"

#include "base/error.h"
#include "base/files.h"
#include "base/terminal.h"
#include "base/text_table.h"
#include "image/colour.h"
#include "image/false_colour.h"
#include "image/image_io.h"
#include "json/writer.h"
#include "metrics/table.h"
#include "report/junit.h"
#include "report/packed_image.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <limits>
#include <map>
#include <system_error>
#include <vector>

#include <fmt/format.h>
#include <unistd.h>

namespace orbs::cli {

namespace {

namespace fs = std::filesystem;

// Two images of one name, or what is wrong with them.
struct Pair {
  std::string name;
  std::string problem{};  // why there is no number; "" if there is one
  std::optional<double> value{};
  bool is_beyond = false;
  double badness = std::numeric_limits<double>::infinity();  // what has no number comes first
  std::string pictures{};                                    // of the page
};

// What looks like an image below a folder.
struct Images {
  // By name relative to the folder with "/" between its parts and the ending in lower case, as it is there.
  std::map<std::string, std::string> files;
  std::vector<Pair> not_compared;  // with the reason
};

std::string with_lower_ending(const std::string& name) {
  const auto ending = fs::path(name).extension().string().size();
  std::string lower = name;
  std::transform(lower.end() - static_cast<std::ptrdiff_t>(ending), lower.end(),
                 lower.end() - static_cast<std::ptrdiff_t>(ending),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return lower;
}

Images images_in(const fs::path& folder) {
  if (!fs::is_directory(folder))
    throw InputError(fmt::format("{} is no folder; name two images or two folders", folder.string()));
  Images images;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_directory() || !image::looks_like_image(entry.path())) continue;
    const auto name = entry.path().lexically_relative(folder).generic_string();
    std::error_code failed;
    if (!entry.is_regular_file(failed))
      images.not_compared.push_back({name, fmt::format("is no file in {}", folder.string())});
    else if (!image::is_image_name(entry.path()))
      images.not_compared.push_back(
          {name, fmt::format("is of a format that is not read, in {}", folder.string())});
    else if (!images.files.emplace(with_lower_ending(name), name).second)
      images.not_compared.push_back(
          {name, fmt::format("has the name of another image in {} but for the case of its ending",
                             folder.string())});
  }
  return images;
}

double badness_of(const metrics::MetricInfo& metric, const std::optional<double>& value) {
  if (!value || std::isnan(*value)) return std::numeric_limits<double>::infinity();
  switch (metric.better) {
    case metrics::Better::Lower:
      return *value;
    case metrics::Better::Higher:
      return -*value;
    case metrics::Better::NearZero:
      return std::abs(*value);
  }
  return 0;
}

std::string picture(const image::Image& shown, const char* what) {
  return fmt::format(
      "<figure><img alt=\"{0}\" src=\"data:image/png;base64,{1}\"><figcaption>{0}</figcaption></figure>",
      what, report::base64(image::png_bytes(shown)));
}

// Result, reference, and the first error map on a scale up to its own greatest value.
std::string pictures_of(const ComparedImages& compared) {
  auto text = picture(image::display_image(compared.first), "result") +
              picture(image::display_image(compared.second), "reference");
  for (const auto& map : compared.comparison.maps) {
    const auto scale = map.info.is_signed ? image::ColourScale::Diverging : image::ColourScale::Sequential;
    const float most = image::largest_magnitude(map.image);
    text += picture(image::false_colour(map.image, scale, most > 0 ? most : 1), "difference");
    break;
  }
  return text;
}

Pair compare_pair(const std::string& first, const std::string& second, const CompareOptions& options) {
  Pair pair{first};
  try {
    const auto compared = compare_images((fs::path(options.first) / first).string(),
                                         (fs::path(options.second) / second).string(), options);
    pair.value = metrics::value_of(compared.comparison, options.metric);
    pair.badness = badness_of(metrics::find_metric(options.metric), pair.value);
    pair.is_beyond = is_beyond(options, pair.value);
    if (!options.page.empty()) pair.pictures = pictures_of(compared);
  } catch (const InputError& e) {
    pair.problem = e.what();
  }
  return pair;
}

// All names of both, the worst first; of equal ones in the order of their names.
std::vector<Pair> compared_pairs(const CompareOptions& options) {
  const auto first = images_in(options.first);
  const auto second = images_in(options.second);
  std::vector<Pair> pairs;
  for (const auto& [name, file] : first.files) {
    if (const auto same = second.files.find(name); same != second.files.end())
      pairs.push_back(compare_pair(file, same->second, options));
    else
      pairs.push_back({file, fmt::format("is missing in {}", options.second)});
  }
  for (const auto& [name, file] : second.files)
    if (!first.files.contains(name)) pairs.push_back({file, fmt::format("is missing in {}", options.first)});
  for (const auto* images : {&first, &second})
    pairs.insert(pairs.end(), images->not_compared.begin(), images->not_compared.end());
  std::stable_sort(pairs.begin(), pairs.end(), [](const Pair& a, const Pair& b) { return a.name < b.name; });
  std::stable_sort(pairs.begin(), pairs.end(),
                   [](const Pair& a, const Pair& b) { return a.badness > b.badness; });
  return pairs;
}

std::string value_text(const Pair& pair) {
  if (!pair.problem.empty()) return "-";
  if (!pair.value) return "undefined";
  return std::isinf(*pair.value) ? "infinite" : fmt::format("{:.4g}", *pair.value);
}

std::string state_of(const Pair& pair) {
  if (!pair.problem.empty()) return pair.problem;
  return pair.is_beyond ? "beyond the tolerance" : "";
}

std::string page_of(const std::vector<Pair>& pairs,
                    const CompareOptions& options,
                    const std::string& headline) {
  constexpr const char* kHead = R"(<!doctype html>
<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width">
<title>Compared images</title>
<style>
:root { color-scheme: light dark; font: 14px/1.4 system-ui, sans-serif; }
body { margin: 1.5rem; }
h2 { font-size: 1rem; margin: 1.5rem 0 .3rem; overflow-wrap: anywhere; }
.beyond { color: #d33; }
.images { display: flex; flex-wrap: wrap; gap: .5rem; }
figure { margin: 0; flex: 1 1 15rem; max-width: 32rem; }
img { width: 100%; image-rendering: pixelated; }
</style></head><body>
)";
  auto text = fmt::format("{}<h1>{} and {}</h1>\n<p>{}</p>\n", kHead, report::xml_text(options.first),
                          report::xml_text(options.second), report::xml_text(headline));
  for (const auto& pair : pairs)
    text += fmt::format("<h2{}>{}</h2>\n<p>{} {}; {}</p>\n<div class=\"images\">{}</div>\n",
                        pair.is_beyond || !pair.problem.empty() ? " class=\"beyond\"" : "",
                        report::xml_text(pair.name), options.metric, value_text(pair),
                        report::xml_text(state_of(pair)), pair.pictures);
  return text + "</body></html>\n";
}

void print_json(const std::vector<Pair>& pairs, const CompareOptions& options) {
  json::Writer out;
  out.begin_object().member("format", "orbs-folder-comparison/1").member("images", options.first);
  out.member("references", options.second).member("metric", options.metric).key("pairs").begin_array();
  for (const auto& pair : pairs) {
    out.begin_object().member("name", pair.name);
    if (pair.value) {
      // JSON holds no infinite number.
      if (std::isinf(*pair.value))
        out.member("value", *pair.value > 0 ? "infinite" : "-infinite");
      else
        out.member("value", *pair.value);
    }
    if (!pair.problem.empty()) out.member("problem", pair.problem);
    out.member("within_tolerance", pair.problem.empty() && !pair.is_beyond).end_object();
  }
  print_raw(stdout, out.end_array().end_object().text());
}

}  // namespace

int compare_folders(const CompareOptions& given) {
  auto options = given;
  if (options.metric.empty()) options.metric = "psnr_srgb8";
  if (!options.maps.empty())
    throw InputError("--maps writes the error maps of two images; -o writes a page of two folders");
  if (!options.page.empty()) check_output_file(options.page);
  const auto pairs = compared_pairs(options);
  if (pairs.empty()) throw InputError(fmt::format("{} and {} hold no images", options.first, options.second));
  const auto count = [&](auto&& is_counted) { return std::count_if(pairs.begin(), pairs.end(), is_counted); };
  const auto unpaired = count([](const Pair& pair) { return !pair.problem.empty(); });
  const auto beyond = count([](const Pair& pair) { return pair.is_beyond; });
  const auto headline = fmt::format("{} images: {} beyond the tolerance, {} missing or not comparable",
                                    pairs.size(), beyond, unpaired);
  if (!options.page.empty()) write_file(options.page, page_of(pairs, options, headline));
  if (options.as_json) {
    print_json(pairs, options);
  } else {
    std::vector<TableRow> rows{{options.metric, "image", ""}};
    for (const auto& pair : pairs) rows.push_back({value_text(pair), pair.name, state_of(pair)});
    print_clean("{}{}\n", text_table(rows, {}, {terminal_width(STDOUT_FILENO), {}}), headline);
    if (beyond > 0) print_clean("{}\n", tolerance_text(options));
  }
  return beyond + unpaired > 0 ? 1 : 0;
}

}  // namespace orbs::cli
