#include "judge/qualified.h"

#include "base/files.h"
#include "judge/reference.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace orbs::judge {

namespace {

using results::GateRecord;

// The largest of several errors; nothing as soon as one of them is unknown.
struct Largest {
  std::optional<double> value = 0.0;

  void add(const std::optional<double>& other) {
    value = value && other ? std::optional(std::max(*value, *other)) : std::nullopt;
  }
  std::string text() const { return value ? fmt::format("{:.2g} %", 100 * *value) : "nothing tried"; }
};

std::string limit_text(const std::optional<double>& limit) { return limit ? fmt::format("{}", *limit) : "-"; }

// Gates that every case has are the program's, like the definitions of its metrics.
bool is_default(const registry::Gate& gate) {
  const auto defaults = registry::default_gates();
  return std::any_of(defaults.begin(), defaults.end(), [&](const registry::Gate& other) {
    return other.metric == gate.metric && other.min == gate.min && other.max == gate.max;
  });
}

// Every number of the case itself that the verdict on this target depends on, one condition a line.
std::string conditions_text(const registry::Case& one_case, const std::string& target) {
  std::string text;
  for (const auto& gate : one_case.gates)
    if (!is_default(gate))
      text += fmt::format("gate {} {} {}\n", gate.metric, limit_text(gate.min), limit_text(gate.max));
  for (const auto& mask : one_case.masks)
    if (mask.target == target)
      for (const auto& rectangle : mask.rectangles)
        text += fmt::format("mask {}\n", rectangle_text(rectangle));
  for (const auto& check : one_case.pixel_checks)
    if (check.target == target)
      text += fmt::format("pixels {} {} {}{}\n", rectangle_text(check.region), fmt::join(check.expected, " "),
                          check.tolerance,
                          check.standard_errors > 0 ? fmt::format(" {}", check.standard_errors) : "");
  for (const auto& share : one_case.path_shares)
    if (share.scene == target) text += fmt::format("path {} {}\n", share.path_class, share.min_share);
  if (!one_case.negative_values.empty()) text += "negative values\n";
  return text;
}

}  // namespace

std::string gate_hash(const registry::Case& one_case,
                      const std::string& target,
                      const std::filesystem::path& references) {
  auto hash = content_hash(conditions_text(one_case, target));
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

}  // namespace orbs::judge
