// What is stored about the gates of each suite. Those of the suite orbs at full size each can fail, and
// notice a bias of 1 %; the other suites have scenes of one colour, few checks or much noise, of which
// docs/understand/verdicts.md has a table.
#include "judge/qualified.h"
#include "registry/cases.h"
#include "registry/configuration.h"
#include "results/qualification.h"

#include <map>
#include <string>

#include <gtest/gtest.h>

using namespace orbs;

namespace {

std::vector<registry::Suite> suites() {
  return registry::load_configuration(ORBS_SOURCE_DIR "/configuration.json").suites;
}

std::vector<results::GateRecord> stored_gates(const registry::Suite& suite, const std::string& size) {
  return results::read_qualification(suite.references / results::qualification_file(size));
}

// Of the suite that is the first in the configuration, orbs.
std::vector<results::GateRecord> gates_of_orbs() {
  auto gates = stored_gates(suites().front(), "1");
  EXPECT_GT(gates.size(), 40U);
  return gates;
}

// The last of its bounces is a third of a percent of the light, in shadows 3.7 % where 2.4 % are allowed: the
// noise of the samples that the case asks for hides it. docs/understand/verdicts.md says so.
bool is_hidden_by_noise(const results::GateRecord& gate, const results::MutantRecord& mutant) {
  return gate.target == "a4-ball" && mutant.fault == "one-bounce-less";
}

}  // namespace

TEST(StoredQualification, EveryGateAcceptsAControlImageAndRejectsEveryFault) {
  for (const auto& gate : gates_of_orbs()) {
    EXPECT_TRUE(gate.accepts_control) << gate.target << ": " << gate.control_reason;
    for (const auto& mutant : gate.mutants)
      EXPECT_NE(mutant.rejected || !mutant.no_fault.empty(), is_hidden_by_noise(gate, mutant))
          << gate.target << ": " << mutant.fault << " " << mutant.reason;
  }
}

TEST(StoredQualification, EveryGateNoticesABiasOfOnePercent) {
  for (const auto& gate : gates_of_orbs()) {
    ASSERT_TRUE(gate.global.seen) << gate.case_name << " " << gate.target;
    EXPECT_LE(*gate.global.seen, 0.01) << gate.case_name << " " << gate.target;
  }
}

// What is not accepted is too noisy to tell, and nothing makes up for an image that is black or no image.
TEST(StoredQualification, NoControlImageIsWrongAndNoBlackImageRight) {
  for (const auto& suite : suites())
    for (const char* size : {"1", "1/4"})
      for (const auto& gate : stored_gates(suite, size)) {
        EXPECT_TRUE(gate.accepts_control || gate.control_reason.starts_with("inconclusive"))
            << suite.name << " " << size << " " << gate.target << ": " << gate.control_reason;
        for (const auto& mutant : gate.mutants) {
          const bool is_no_image = mutant.fault == "black" || mutant.fault == "one NaN";
          EXPECT_TRUE(mutant.rejected || !mutant.no_fault.empty() || !is_no_image)
              << suite.name << " " << size << " " << gate.target << ": " << mutant.reason;
        }
      }
}

// The numbers hold for the gates and references as they are: orbs qualify finds them anew. At 1/4 masks and
// regions are others than those of the case's file.
TEST(StoredQualification, IsOfTheGatesAndReferencesThatThereAre) {
  for (const auto& suite : suites()) {
    std::map<std::string, std::string> hashes;
    for (const auto& one_case : registry::load_cases(suite))
      for (const auto& target : registry::target_names(one_case))
        hashes[one_case.name + " " + target] = judge::gate_hash(one_case, target, suite.references);
    for (const auto& gate : stored_gates(suite, "1")) {
      const auto name = gate.case_name + " " + gate.target;
      ASSERT_TRUE(hashes.contains(name)) << name << " is no target any more";
      EXPECT_EQ(gate.judged_by, hashes.at(name)) << suite.name << " " << name;
    }
  }
}
