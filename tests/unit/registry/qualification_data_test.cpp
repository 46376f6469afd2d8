// What is stored about the gates of each suite: every one can fail, and notices a bias of 1 %.
#include "judge/qualified.h"
#include "registry/cases.h"
#include "registry/configuration.h"
#include "results/qualification.h"

#include <map>
#include <string>

#include <gtest/gtest.h>

using namespace orbs;

namespace {

// Of the suites that have been qualified.
std::vector<results::GateRecord> stored_gates() {
  std::vector<results::GateRecord> gates;
  for (const auto& suite : registry::load_configuration(ORBS_SOURCE_DIR "/configuration.json").suites)
    for (auto& gate : results::read_qualification(suite.references / results::qualification_file("1")))
      gates.push_back(std::move(gate));
  EXPECT_GT(gates.size(), 40U);
  return gates;
}

}  // namespace

TEST(StoredQualification, EveryGateAcceptsAControlImageAndRejectsEveryFault) {
  for (const auto& gate : stored_gates()) {
    EXPECT_TRUE(gate.accepts_control) << gate.target << ": " << gate.control_reason;
    EXPECT_TRUE(results::is_qualified(gate)) << gate.case_name << " " << gate.target;
  }
}

TEST(StoredQualification, EveryGateNoticesABiasOfOnePercent) {
  for (const auto& gate : stored_gates()) {
    ASSERT_TRUE(gate.global.seen) << gate.case_name << " " << gate.target;
    EXPECT_LE(*gate.global.seen, 0.01) << gate.case_name << " " << gate.target;
  }
}

// The numbers hold for the gates and references as they are: orbs qualify finds them anew.
TEST(StoredQualification, IsOfTheGatesAndReferencesThatThereAre) {
  std::map<std::string, std::string> hashes;
  for (const auto& suite : registry::load_configuration(ORBS_SOURCE_DIR "/configuration.json").suites)
    for (const auto& one_case : registry::load_cases(suite))
      for (const auto& target : registry::target_names(one_case))
        hashes[one_case.name + " " + target] = judge::gate_hash(one_case, target, suite.references);
  for (const auto& gate : stored_gates()) {
    const auto name = gate.case_name + " " + gate.target;
    ASSERT_TRUE(hashes.contains(name)) << name << " is no target any more";
    EXPECT_EQ(gate.judged_by, hashes.at(name)) << name;
  }
}
