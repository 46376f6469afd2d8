#include "references/history.h"

#include "base/error.h"
#include "base/files.h"
#include "base/local_time.h"
#include "image/image_io.h"
#include "json/document.h"
#include "json/object_reader.h"
#include "json/writer.h"
#include "judge/provenance.h"
#include "run/execute.h"

namespace orbs::references {

namespace {

ReplacedReference read_entry(json::ObjectReader in) {
  ReplacedReference entry{in.text("replaced"), in.text("reason"), in.text_or("problem", ""), {}};
  auto provenance = in.object("provenance");
  for (const auto& key : provenance.keys()) entry.provenance[key] = provenance.text(key);
  in.finish();
  return entry;
}

void write_entry(json::Writer& out, const ReplacedReference& entry) {
  out.begin_object().member("replaced", entry.replaced).member("reason", entry.reason);
  if (!entry.problem.empty()) out.member("problem", entry.problem);
  out.key("provenance").begin_object();
  for (const auto& [key, text] : entry.provenance) out.member(key, text);
  out.end_object().end_object();
}

// A broken file gets an entry, too.
ReplacedReference entry_of(const std::filesystem::path& reference, const std::string& reason) {
  ReplacedReference entry{local_time_now(), reason, "", {}};
  try {
    const auto image = image::read_image(reference);
    entry.provenance = judge::provenance_of(image);
    entry.provenance["image_hash"] = judge::image_hash(image);
  } catch (const InputError& e) {
    entry.problem = e.what();
  }
  return entry;
}

}  // namespace

std::filesystem::path history_file(const std::filesystem::path& reference) {
  return reference.parent_path() / (reference.stem().string() + ".history.json");
}

std::vector<ReplacedReference> read_history(const std::filesystem::path& reference) {
  const auto file = history_file(reference);
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored)) return {};
  const auto document = json::parse_file(file);
  json::ObjectReader in(document);
  in.one_of("format", {"orbs-history/2"});
  std::vector<ReplacedReference> entries;
  for (auto& entry : in.objects("replaced")) entries.push_back(read_entry(std::move(entry)));
  in.finish();
  return entries;
}

void note_replaced(const std::filesystem::path& reference, const std::string& reason) {
  auto entries = read_history(reference);
  auto entry = entry_of(reference, reason);
  // The pixels alone do not tell: the same render made twice has two dates.
  if (!entries.empty() && entry.problem.empty() && entries.back().provenance == entry.provenance) return;
  entries.push_back(std::move(entry));
  json::Writer out;
  out.begin_object().member("format", "orbs-history/2").key("replaced").begin_array();
  for (const auto& one : entries) write_entry(out, one);
  write_file(history_file(reference), out.end_array().end_object().text());
}

}  // namespace orbs::references
