#include "studies/qualify.h"

#include <algorithm>

#include <fmt/format.h>

namespace orbs::studies {

namespace {

using results::GateRecord;

std::string percent(const std::optional<double>& share) {
  return share ? fmt::format("{:.2g} %", 100 * *share) : "-";
}

std::string row(const GateRecord& gate) {
  const auto is_fault = [](const auto& twin) { return twin.no_fault.empty(); };
  const auto is_rejected = [](const auto& twin) { return twin.no_fault.empty() && twin.rejected; };
  const auto faults = std::count_if(gate.twins.begin(), gate.twins.end(), is_fault);
  const auto rejected = std::count_if(gate.twins.begin(), gate.twins.end(), is_rejected);
  return fmt::format("{:<24} {:<18} {:<8} {:>8} {:>9} {:>9} {:>9} {:>9}  {}\n", gate.case_name, gate.target,
                     gate.accepts_honest ? "accepted" : "refused", fmt::format("{}/{}", rejected, faults),
                     percent(gate.global.seen), percent(gate.global.rejected), percent(gate.local.seen),
                     percent(gate.local.rejected), results::is_qualified(gate) ? "yes" : "NO");
}

std::string complaints(const GateRecord& gate) {
  std::string text;
  if (!gate.accepts_honest)
    text += fmt::format("{} {}: an honest image is not accepted: {}\n", gate.case_name, gate.target,
                        gate.honest_reason);
  for (const auto& twin : gate.twins)
    if (twin.no_fault.empty() && !twin.rejected)
      text += fmt::format("{} {}: '{}' is not rejected: {}\n", gate.case_name, gate.target, twin.fault,
                          twin.reason);
  return text;
}

std::string no_faults(const GateRecord& gate) {
  std::string text;
  for (const auto& twin : gate.twins)
    if (!twin.no_fault.empty())
      text += fmt::format("{} {}: '{}' is no fault here: {}\n", gate.case_name, gate.target, twin.fault,
                          twin.no_fault);
  return text;
}

}  // namespace

std::string qualification_text(const std::vector<GateRecord>& gates) {
  auto text = fmt::format("{:<24} {:<18} {:<8} {:>8} {:>19} {:>19}\n", "", "", "honest", "faults",
                          "light everywhere", "leak of mean light");
  text += fmt::format("{:<24} {:<18} {:<8} {:>8} {:>9} {:>9} {:>9} {:>9}  {}\n", "case", "target", "target",
                      "rejected", "remark", "failure", "remark", "failure", "qualified");
  for (const auto& gate : gates) text += row(gate);
  text += '\n';
  for (const auto& gate : gates) text += no_faults(gate);
  for (const auto& gate : gates) text += complaints(gate);
  const auto count = std::count_if(gates.begin(), gates.end(), results::is_qualified);
  return text + fmt::format("{} of {} gates are qualified\n", count, gates.size());
}

}  // namespace orbs::studies
