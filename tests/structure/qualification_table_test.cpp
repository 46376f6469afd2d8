// What `orbs qualify` found of every suite: the table of docs/understand/verdicts.md is made of the files
// beside the references.
#include "registry/cases.h"
#include "results/qualification.h"
#include "structure/documentation.h"

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace {

using orbs::results::GateRecord;

// The largest of what the gates of a group find at the least; nothing once one of them finds nothing.
struct Largest {
  std::optional<double> value = 0.0;

  void add(const std::optional<double>& other) {
    value = value && other ? std::optional(std::max(*value, *other)) : std::nullopt;
  }
  std::string text() const { return value ? fmt::format("{:.2g} %", 100 * *value) : "not by all"; }
};

struct Group {
  int gates = 0;
  int accepted = 0;
  int faults = 0;
  int rejected = 0;
  Largest remark;
  Largest failure;
  Largest leak;

  void add(const GateRecord& gate) {
    ++gates;
    if (!gate.accepts_control) return;  // what it rejects besides says nothing
    ++accepted;
    for (const auto& mutant : gate.mutants) {
      if (!mutant.no_fault.empty()) continue;
      ++faults;
      if (mutant.rejected) ++rejected;
    }
    remark.add(gate.global.seen);
    failure.add(gate.global.rejected);
    leak.add(gate.local.rejected);
  }

  std::string row(const std::string& name) const {
    return fmt::format("| {} | {} of {} | {} of {} | {} | {} | {} |\n", name, accepted, gates, rejected,
                       faults, remark.text(), failure.text(), leak.text());
  }
};

std::string rows_of(const std::filesystem::path& root, const std::string& suite, const std::string& size) {
  const auto file = root / "data/references" / suite / orbs::results::qualification_file(size);
  std::map<std::string, std::string> requirements;  // by case
  for (const auto& one : orbs::registry::load_cases({suite, root / "data/cases" / suite, file.parent_path()}))
    requirements[one.name] = one.requirement;
  std::map<std::string, Group> groups;
  for (const auto& gate : orbs::results::read_qualification(file))
    if (requirements.contains(gate.case_name)) groups[requirements.at(gate.case_name).substr(0, 1)].add(gate);
  std::string rows;
  for (const auto& [letter, group] : groups)
    rows += group.row(fmt::format("{} {} at {}", suite, letter, size));
  return rows;
}

}  // namespace

TEST(QualificationTable, ThePageShowsTheCommittedFiles) {
  const std::filesystem::path root(ORBS_SOURCE_DIR);
  std::string table =
      "| gates | control images accepted | mutants rejected | light: remark from | light: failure from | leak: failure "
      "from |\n|---|---|---|---|---|---|\n";
  for (const char* suite :
       {"orbs", "appearance", "everyday", "shapes", "motion", "integrators", "known", "gi", "stability"}) {
    const std::string rows = rows_of(root, suite, "1") + rows_of(root, suite, "1/4");
    EXPECT_NE(rows, "") << suite << " is not qualified: orbs run -r orbs --suite " << suite
                        << ", orbs qualify --suite " << suite;
    table += rows;
  }
  EXPECT_EQ(
      orbs::structure::check_generated_part(root / "docs/understand/verdicts.md", "qualification", table),
      "");
}
