#include "server/edit.h"

#include "base/error.h"
#include "base/files.h"
#include "base/nth.h"
#include "json/document.h"
#include "json/field_reader.h"
#include "report/file_change.h"
#include "server/http.h"

#include <optional>

#include <fmt/format.h>

namespace orbs::server {

namespace {

// What the page sends to make a failure known.
struct EditRequest {
  int run = 0;
  std::string target{};
  std::string renderer{};
  std::string reason{};
  std::string until{};
  /// The hash of the file whose difference the user has seen and confirms. Without one nothing is written.
  std::optional<std::string> hash{};
};

template <class Visitor, json::RecordOf<EditRequest> Record>
void fields(Visitor& visit, Record& request) {
  visit.required("run", request.run);
  visit.required("target", request.target);
  visit.required("renderer", request.renderer);
  visit.required("reason", request.reason);
  visit("until", request.until);
  visit("hash", request.hash);
}

EditRequest request_of(const std::string& body) {
  const auto document = json::parse("request", body);
  return json::read_settings<EditRequest>(json::ObjectReader(document));
}

// The record of the target alone.
results::RunRecord record_of(Site& site, const EditRequest& request) {
  if (request.run < 0 || static_cast<std::size_t>(request.run) >= site.runs.size())
    throw InputError("there is no such run");
  const auto* owner = std::get_if<std::unique_ptr<ServedRun>>(&nth(site.runs, request.run));
  if (owner == nullptr) throw InputError("a study has no failures");
  if ((*owner)->is_live()) throw InputError("the run goes on: its verdicts can still change");
  auto record = (*owner)->record_of(request.target, request.renderer);
  if (record.targets.empty())
    throw InputError(
        fmt::format("the run has no target '{}' by the renderer '{}'", request.target, request.renderer));
  return record;
}

}  // namespace

void answer_edit(Site& site, const Request& request, Response& response) {
  set_safe_headers(response);
  if (path_of(request) != "/edit/known-failure") return refuse(response, 404, "there is nothing here");
  try {
    const auto asked = request_of(request.body);
    const auto record = record_of(site, asked);
    const std::lock_guard lock(site.editing);
    const auto edited = site.editor->accept_failure(record, asked.reason, asked.until);
    report::FileChange change{edited.file.string(), edited.line,
                              report::unified_diff(edited.before, edited.after, edited.file.string()),
                              hash_text(content_hash(edited.before))};
    if (asked.hash) {
      if (*asked.hash != change.hash)
        return refuse(
            response, 409,
            fmt::format("{} has changed since its difference was shown; nothing was written", change.file));
      site.editor->write(edited.file, edited.after);
      change.written = true;
    }
    set_content(response, report::file_change_json(change), "application/json; charset=utf-8");
  } catch (const InputError& e) {
    refuse(response, 422, e.what());
  }
}

}  // namespace orbs::server
