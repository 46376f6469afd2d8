#include "studies/qualify/report.h"

#include "base/text_table.h"

#include <algorithm>

#include <fmt/format.h>

namespace orbs::studies {

namespace {

using results::GateRecord;

std::string percent(const std::optional<double>& share) {
  return share ? fmt::format("{:.2g} %", 100 * *share) : "-";
}

TableRow row(const GateRecord& gate) {
  const auto is_fault = [](const auto& mutant) { return mutant.no_fault.empty(); };
  const auto is_rejected = [](const auto& mutant) { return mutant.no_fault.empty() && mutant.rejected; };
  const auto faults = std::count_if(gate.mutants.begin(), gate.mutants.end(), is_fault);
  const auto rejected = std::count_if(gate.mutants.begin(), gate.mutants.end(), is_rejected);
  return {gate.case_name,
          gate.target,
          gate.accepts_control ? "accepted" : "refused",
          fmt::format("{}/{}", rejected, faults),
          percent(gate.global.seen),
          percent(gate.global.rejected),
          percent(gate.local.seen),
          percent(gate.local.rejected),
          results::is_qualified(gate) ? "yes" : "NO"};
}

std::string complaints(const GateRecord& gate) {
  std::string text;
  if (!gate.accepts_control)
    text += fmt::format("{} {}: a control image is not accepted: {}\n", gate.case_name, gate.target,
                        gate.control_reason);
  for (const auto& mutant : gate.mutants)
    if (mutant.no_fault.empty() && !mutant.rejected)
      text += fmt::format("{} {}: '{}' is not rejected: {}\n", gate.case_name, gate.target, mutant.fault,
                          mutant.reason);
  return text;
}

std::string no_faults(const GateRecord& gate) {
  std::string text;
  for (const auto& mutant : gate.mutants)
    if (!mutant.no_fault.empty())
      text += fmt::format("{} {}: '{}' is no fault here: {}\n", gate.case_name, gate.target, mutant.fault,
                          mutant.no_fault);
  return text;
}

}  // namespace

std::string qualification_text(const std::vector<GateRecord>& gates) {
  constexpr auto kRight = Align::Right;
  std::vector<TableRow> rows{
      {"", "", "control", "mutants", "light everywhere", "", "leak of mean light", "", ""},
      {"case", "target", "image", "rejected", "remark", "failure", "remark", "failure", "qualified"}};
  for (const auto& gate : gates) rows.push_back(row(gate));
  auto text =
      text_table(rows, {Align::Left, Align::Left, Align::Left, kRight, kRight, kRight, kRight, kRight});
  text += '\n';
  for (const auto& gate : gates) text += no_faults(gate);
  for (const auto& gate : gates) text += complaints(gate);
  const auto count = std::count_if(gates.begin(), gates.end(), results::is_qualified);
  return text + fmt::format("{} of {} gates are qualified\n", count, gates.size());
}

}  // namespace orbs::studies
