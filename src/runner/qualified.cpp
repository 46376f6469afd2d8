#include "runner/qualified.h"

#include "base/files.h"
#include "runner/judge.h"

#include <algorithm>

#include <fmt/format.h>

namespace orbs::runner {

namespace {

using results::GateRecord;

// The largest of all; nothing as soon as one has none.
struct Largest {
  std::optional<double> value = 0.0;

  void add(const std::optional<double>& other) {
    value = value && other ? std::optional(std::max(*value, *other)) : std::nullopt;
  }
  std::string text() const { return value ? fmt::format("{:.2g} %", 100 * *value) : "nothing tried"; }
};

}  // namespace

std::string gate_hash(const registry::Case& one_case,
                      const std::string& target,
                      const std::filesystem::path& references) {
  auto hash = content_hash(read_file(one_case.file));
  std::error_code ignored;
  for (const auto& file : reference_files(one_case, target, references))
    if (std::filesystem::exists(file, ignored)) hash = content_hash(read_file(file), hash);
  return hash_text(hash);
}

std::string smallest_error_seen(const registry::Case& one_case,
                                const std::filesystem::path& references,
                                const std::vector<GateRecord>& gates) {
  Largest global_seen;
  Largest global_rejected;
  Largest local_rejected;
  bool was_tried = false;
  std::string unknown;
  for (const auto& target : registry::target_names(one_case)) {
    const auto gate = std::find_if(gates.begin(), gates.end(), [&](const GateRecord& one) {
      return one.case_name == one_case.name && one.target == target;
    });
    was_tried = was_tried || gate != gates.end();
    if (gate == gates.end() || gate->judged_by != gate_hash(one_case, target, references)) {
      unknown += fmt::format("{}{}", unknown.empty() ? "" : ", ", target);
      continue;
    }
    global_seen.add(gate->global.seen);
    global_rejected.add(gate->global.rejected);
    local_rejected.add(gate->local.rejected);
  }
  if (!was_tried) return "";
  if (!unknown.empty())
    return fmt::format("not known since the case or a reference changed ({}); orbs qualify finds it",
                       unknown);
  return fmt::format(
      "{} more or less light everywhere is a remark, {} a failure; so is a leak of {} of the mean light "
      "into 16 x 16 px",
      global_seen.text(), global_rejected.text(), local_rejected.text());
}

}  // namespace orbs::runner
