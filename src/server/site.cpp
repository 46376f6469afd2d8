#include "server/site.h"

#include "base/error.h"
#include "base/files.h"
#include "base/files_inside.h"
#include "base/nth.h"
#include "base/text.h"
#include "history/comparison_text.h"
#include "image/image_io.h"
#include "json/writer.h"
#include "report/packed_image.h"
#include "results/study_kinds.h"
#include "server/http.h"
#include "studies/cost/change_text.h"
#include "studies/cost/json.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

namespace orbs::server {

namespace {

namespace fs = std::filesystem;

// Content security policy of the page: only the files of the bundle run, only this server is contacted, and
// nothing may frame the page.
constexpr const char* kPagePolicy =
    "default-src 'none'; script-src 'self'; worker-src blob:; style-src 'self'; img-src 'self' blob: data:; "
    "connect-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'";
// Content security policy of files that a renderer left: they are displayed alone and cannot run anything.
constexpr const char* kFilePolicy = "default-src 'none'; sandbox; frame-ancestors 'none'";

struct BundleEntry {
  const char* name;
  const char* type;
};
constexpr std::array kBundle{BundleEntry{"index.html", "text/html; charset=utf-8"},
                             BundleEntry{"page.js", "text/javascript; charset=utf-8"},
                             BundleEntry{"page.css", "text/css; charset=utf-8"},
                             BundleEntry{"icon.svg", "image/svg+xml"}};

constexpr const char* kJson = "application/json; charset=utf-8";
constexpr const char* kText = "text/plain; charset=utf-8";

bool send_bundle_file(const Site& site, const Request& request, std::string_view path, Response& response) {
  const auto name = path == "/" ? std::string_view("index.html") : path.substr(1);
  for (const auto& file : site.bundle) {
    if (file.name != name) continue;
    response.headers.emplace_back("Content-Security-Policy", kPagePolicy);
    send_text(request, file.text, file.type.c_str(), response);
    return true;
  }
  return false;
}

std::string runs_json(Site& site) {
  json::Writer out;
  out.begin_object().member("format", "orbs-runs/1").member("edit", site.editor != nullptr);
  out.key("runs").begin_array();
  for (std::size_t i = 0; i < site.runs.size(); ++i) {
    const auto& served = site.runs[i];
    out.begin_object().member("name", site.names[i]);
    const auto* study = std::get_if<std::unique_ptr<ServedStudy>>(&served);
    const auto* run = std::get_if<std::unique_ptr<ServedRun>>(&served);
    out.member("suite", run != nullptr ? (*run)->suite_and_size() : "");
    out.member("kind", study != nullptr ? (*study)->kind() : std::string_view("run"));
    out.member("started", std::visit([](const auto& one) { return std::string(one->started()); }, served));
    out.end_object();
  }
  return out.end_array().end_object().text();
}

std::string type_of(std::string_view path) {
  if (path.ends_with(".png")) return "image/png";
  if (path.ends_with(".exr") || path.ends_with(".ply")) return "application/octet-stream";
  // HTML and SVG too: output of a renderer is never served as markup.
  return kText;
}

void send_file(const fs::path& folder, const std::string& path, Response& response) {
  auto file = open_inside(folder, path);
  if (!file) return refuse(response, 404, "there is no such file in this run");
  response.headers.emplace_back("Content-Security-Policy", kFilePolicy);
  const auto size = static_cast<std::size_t>(file->size());
  const auto shared = std::make_shared<OpenFile>(std::move(*file));
  response.type = type_of(path);
  response.content = Streamed{size, [shared, size](const Connection& connection) {
                                constexpr std::size_t kPiece = 1U << 16U;
                                for (std::size_t sent = 0; sent < size;) {
                                  const auto bytes = shared->read(sent, std::min(size - sent, kPiece));
                                  if (bytes.empty() || !connection.send(bytes)) return;
                                  sent += bytes.size();
                                }
                              }};
}

enum class Form { Packed, Preview };

// The bytes of an image in the form that the page asks for.
std::string image_bytes(const OpenFile& file, const std::string& path, const std::string& layer, Form form) {
  const auto image = image::read_exr(path, file.read(0, static_cast<std::size_t>(file.size())));
  if (form == Form::Preview) return report::preview_png(image);
  return report::packed_image(image, layer, report::Rounding::Exact, report::Packing::Fast);
}

void send_image(Site& site,
                const fs::path& folder,
                const std::string& path,
                const std::string& layer,
                Form form,
                Response& response) {
  if (!path.ends_with(".exr")) return refuse(response, 404, "only EXR images are packed");
  const auto file = open_inside(folder, path);
  if (!file) return refuse(response, 404, "there is no such image in this run");
  constexpr std::uint64_t kMostBytes = std::uint64_t{2} << 30U;
  if (file->size() > kMostBytes) return refuse(response, 422, "the image is larger than 2 GiB");
  // A preview decodes the whole image, which is decoded again for its floats: 0.1 s for 32 MB.
  constexpr std::uint64_t kMostPreviewed = std::uint64_t{32} << 20U;
  if (form == Form::Preview && file->size() > kMostPreviewed)
    return refuse(response, 422, "the image is larger than 32 MiB and has no preview");
  // A run that goes on or is resumed may write the image again, even with the same size.
  const auto key =
      fmt::format("{}\n{}\n{}\n{}\n{}", static_cast<int>(form), folder.string(), path, layer, file->state());
  const auto bytes = site.images.get(key, [&] { return image_bytes(*file, path, layer, form); });
  response.type = form == Form::Preview ? "image/png" : "application/octet-stream";
  response.content =
      Streamed{bytes->size(), [bytes](const Connection& connection) { connection.send(*bytes); }};
}

void send_target(ServedRun& run, const Request& request, std::string_view name, Response& response) {
  const auto stem = name.ends_with(".json") ? name.substr(0, name.size() - 5) : std::string_view();
  const auto index = to_integer(stem);
  const auto text = index && *index >= 0 ? run.target(static_cast<std::size_t>(*index)) : std::nullopt;
  if (!text) return refuse(response, 404, "this run has no such target");
  send_text(request, packed_text(*text), kJson, response);
}

// The run or study that "3.json" names; null if there is none of that kind.
template <class Kind>
const std::unique_ptr<Kind>* served_named(Site& site, std::string_view name) {
  const auto number = to_integer(name.ends_with(".json") ? name.substr(0, name.size() - 5) : name);
  if (!number || *number < 0 || static_cast<std::size_t>(*number) >= site.runs.size()) return nullptr;
  return std::get_if<std::unique_ptr<Kind>>(&nth(site.runs, *number));
}

// What `orbs compare-runs` says of two runs, or of one renderer of each.
void send_comparison(
    Site& site, ServedRun& after, std::string_view name, const Request& request, Response& response) {
  const auto* const before = served_named<ServedRun>(site, name);
  if (before == nullptr) return refuse(response, 404, "there is no such run");
  const auto old_renderer = parameter(request, "ra");
  const auto new_renderer = parameter(request, "rb");
  const bool is_of_one = !old_renderer.empty() && !new_renderer.empty();
  const auto side = [&](ServedRun& run, const std::string& renderer) {
    return is_of_one ? history::with_renderer(run.record(), renderer, new_renderer) : run.record();
  };
  const auto comparison = history::compare_runs(side(**before, old_renderer), side(after, new_renderer));
  send_text(request, packed_text(history::comparison_json(comparison)), kJson, response);
}

// What `orbs compare-runs` says of two studies of cost.
void send_cost_changes(
    Site& site, const ServedStudy& after, std::string_view name, const Request& request, Response& response) {
  const auto* const before = served_named<ServedStudy>(site, name);
  if (before == nullptr || (*before)->kind() != results::kCost.name || after.kind() != results::kCost.name)
    return refuse(response, 404, "there is no such study of cost");
  const auto read = [](const ServedStudy& study) {
    return studies::read_cost_file(study.folder() / results::kCost.file);
  };
  const auto changes = studies::cost_changes(read(**before), read(after));
  send_text(request, packed_text(studies::changes_json(changes)), kJson, response);
}

// `path` without "/data/".
void send_data(Site& site, const Request& request, const std::string& path, Response& response) {
  if (path == "runs.json") return set_content(response, runs_json(site), kJson);
  const auto slash = path.find('/');
  const auto number = to_integer(path.substr(0, slash));
  if (slash == std::string::npos || !number || *number < 0 ||
      static_cast<std::size_t>(*number) >= site.runs.size())
    return refuse(response, 404, "there is no such run");
  const auto& served = nth(site.runs, *number);
  const auto rest = path.substr(slash + 1);
  const auto after = [&](std::string_view start) { return rest.substr(start.size()); };
  const auto folder = std::visit([](const auto& one) { return one->folder(); }, served);
  const auto layer = parameter(request, "layer");
  if (rest.starts_with("image/"))
    return send_image(site, folder, after("image/"), layer, Form::Packed, response);
  if (rest.starts_with("preview/"))
    return send_image(site, folder, after("preview/"), "", Form::Preview, response);
  if (rest.starts_with("file/")) return send_file(folder, after("file/"), response);
  if (const auto* study = std::get_if<std::unique_ptr<ServedStudy>>(&served);
      study != nullptr && rest.starts_with("before/"))
    return send_cost_changes(site, **study, after("before/"), request, response);
  const auto* owner = std::get_if<std::unique_ptr<ServedRun>>(&served);
  if (owner == nullptr) return refuse(response, 404, "a study has only images, files and comparisons");
  auto& run = **owner;
  if (rest == "overview.json") return send_text(request, *run.overview(), kJson, response);
  if (rest == "events") return send_events(site.listeners, run, response);
  if (rest.starts_with("target/")) return send_target(run, request, after("target/"), response);
  if (rest.starts_with("before/")) return send_comparison(site, run, after("before/"), request, response);
  refuse(response, 404, "there is nothing here");
}

}  // namespace

Served open_served(const fs::path& folder) {
  if (results::study_kind_in(folder) != nullptr) return std::make_unique<ServedStudy>(folder);
  return std::make_unique<ServedRun>(folder);
}

const fs::path& named(const Served& served) {
  return std::visit([](const auto& one) -> const fs::path& { return one->named(); }, served);
}

std::vector<BundleFile> load_bundle(const std::filesystem::path& folder) {
  std::vector<BundleFile> files;
  for (const auto& [name, type] : kBundle) {
    if (!std::filesystem::exists(folder / name))
      throw InputError(
          fmt::format("{}: is missing: the results page has not been built; './bootstrap build' makes it "
                      "and says what it needs (Node.js 18 or newer and npm)",
                      (folder / name).string()));
    files.push_back({name, type, packed_text(read_file(folder / name))});
  }
  return files;
}

void set_safe_headers(Response& response) {
  response.headers.emplace_back("X-Content-Type-Options", "nosniff");
  response.headers.emplace_back("Referrer-Policy", "no-referrer");
  response.headers.emplace_back("Cross-Origin-Resource-Policy", "same-origin");
  response.headers.emplace_back("Cross-Origin-Opener-Policy", "same-origin");
  response.headers.emplace_back("Cache-Control", "no-store");
  response.status = 200;
}

void answer(Site& site, const Request& request, Response& response) {
  set_safe_headers(response);
  const auto path = path_of(request);
  try {
    if (send_bundle_file(site, request, path, response)) return;
    if (path.starts_with("/data/")) return send_data(site, request, path.substr(6), response);
    refuse(response, 404, "there is nothing here");
  } catch (const InputError& e) {
    refuse(response, 422, e.what());
  }
}

}  // namespace orbs::server
