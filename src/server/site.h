#pragma once

#include "server/editor.h"
#include "server/events.h"
#include "server/http.h"
#include "server/image_cache.h"
#include "server/packed_text.h"
#include "server/served.h"

#include <filesystem>
#include <memory>
#include <mutex>
#include <string>
#include <variant>
#include <vector>

/// The addresses of the server:
///   /, /page.js, /page.css ...              the bundle
///   /data/runs.json                          the runs and studies that are served
///   /data/<run>/overview.json                report::overview_json
///   /data/<run>/target/<index>.json          report::target_json
///   /data/<run>/image/<path>.exr?layer=...   an image of the run's folder, packed (report::packed_image)
///   /data/<run>/preview/<path>.exr           a small PNG of it (report::preview_png)
///   /data/<run>/file/<path>                  a file of the run's folder as it is
///   /data/<run>/events                       progress of a run that goes on, as server-sent events
///   /edit/known-failure                      POST: see edit.h
/// <run> counts from 0, over runs and studies. A study has only image/, preview/ and file/; the page reads
/// its file, such as file/cost.json.
namespace orbs::server {

struct BundleFile {
  std::string name;  // "page.js"
  std::string type;
  PackedText text;
};

using Served = std::variant<std::unique_ptr<ServedRun>, std::unique_ptr<ServedStudy>>;

/// A run or a study, whichever the folder holds. InputError if it holds neither.
Served open_served(const std::filesystem::path& folder);
const std::filesystem::path& named(const Served& served);

struct Site {
  std::vector<Served> runs;
  std::vector<std::string> names;  // of the runs
  std::vector<BundleFile> bundle;
  ImageCache images{std::size_t{256} << 20U, 2};
  EventClients listeners;
  const Editor* editor = nullptr;  // null: the page is read-only
  std::mutex editing;              // held while a file is changed
};

/// Reads the bundle. InputError if it is missing; the message names the command that builds it.
std::vector<BundleFile> load_bundle(const std::filesystem::path& folder);

/// Answers one admitted request that changes nothing.
void answer(Site& site, const Request& request, Response& response);

/// Headers that every answer has: it is not kept, its type is not guessed, and other pages learn nothing of
/// it.
void set_safe_headers(Response& response);

}  // namespace orbs::server
