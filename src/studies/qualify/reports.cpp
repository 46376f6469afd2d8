#include "studies/qualify/reports.h"

#include "base/nth.h"
#include "base/text_table.h"

#include <algorithm>
#include <array>
#include <map>

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

namespace {

constexpr int kAnswers = 5;
constexpr int kKnowledges = 4;

struct Counts {
  std::array<int, kAnswers> of{};
  int all = 0;
};

using ByKnowledge = std::array<Counts, kKnowledges>;

void add(const JudgedImage& image, ByKnowledge& counts) {
  auto& one = counts.at(static_cast<std::size_t>(image.knowledge));
  ++one.of.at(static_cast<std::size_t>(image.answer));
  ++one.all;
}

// "5 rejected, 1 silent": only what is not zero.
std::string counts_text(const Counts& counts) {
  std::string text;
  for (int i = 0; i < kAnswers; ++i)
    if (const int count = counts.of.at(static_cast<std::size_t>(i)); count > 0)
      text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, name_of(static_cast<Answer>(i)));
  return text;
}

TableRow row_of(const std::string& name, const ByKnowledge& counts) {
  TableRow row{name};
  for (const auto& one : counts) row.push_back(counts_text(one));
  return row;
}

int called_wrong(const Counts& counts) {
  return nth(counts.of, Answer::Rejected) + nth(counts.of, Answer::Remarked);
}

std::string controls_line(const ByKnowledge& controls) {
  int all = 0;
  int wrong = 0;
  int inconclusive = 0;
  for (const auto& one : controls) {
    all += one.all;
    wrong += called_wrong(one);
    inconclusive += nth(one.of, Answer::Inconclusive);
  }
  return fmt::format("{} of {} control images were called wrong, {} inconclusive\n", wrong, all,
                     inconclusive);
}

}  // namespace

std::string sensitivity_text(const std::vector<JudgedImage>& images) {
  std::vector<std::string> order;
  std::map<std::string, ByKnowledge> faults;
  ByKnowledge controls{};
  std::string silent;
  for (const auto& image : images) {
    if (image.fault.empty()) {
      add(image, controls);
      if (image.answer == Answer::Rejected || image.answer == Answer::Remarked)
        silent += fmt::format("{} {} seeds {} and {}: a control image: {}\n", image.target,
                              name_of(image.knowledge), image.seed, image.second, image.reason);
      continue;
    }
    if (!faults.contains(image.fault)) order.push_back(image.fault);
    add(image, faults[image.fault]);
    if (image.answer == Answer::Silent)
      silent +=
          fmt::format("{} {}: '{}' passes silently\n", image.target, name_of(image.knowledge), image.fault);
  }
  TableRow head{"fault"};
  for (int i = 0; i < kKnowledges; ++i) head.emplace_back(name_of(static_cast<NoiseKnowledge>(i)));
  std::vector<TableRow> rows{head};
  for (const auto& name : order) rows.push_back(row_of(name, faults.at(name)));
  rows.push_back(row_of("(control image)", controls));
  return text_table(rows, {}) + "\n" + silent + controls_line(controls);
}

std::string controls_csv(const std::string& suite,
                         const std::string& size,
                         const std::vector<JudgedImage>& images) {
  ByKnowledge controls{};
  for (const auto& image : images)
    if (image.fault.empty()) add(image, controls);
  std::string text;
  for (int i = 0; i < kKnowledges; ++i) {
    const auto& counts = nth(controls, i);
    text += fmt::format("{},{},{},{},{},{}\n", suite, size, name_of(static_cast<NoiseKnowledge>(i)),
                        counts.all, nth(counts.of, Answer::Inconclusive), called_wrong(counts));
  }
  return text;
}

}  // namespace orbs::studies
