// JUnit XML as the parsers of CI servers read it.
#include "report/junit.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

using namespace orbs::results;
using orbs::report::junit_xml;

namespace {

TargetRecord target_of(const std::string& scene, Verdict verdict, const std::string& reason) {
  TargetRecord target;
  target.requirement = "M1";
  target.case_name = "m1";
  target.target = scene;
  target.renderer = "r";
  target.declared = true;
  target.jobs = {scene + "-id"};
  target.verdict = verdict;
  target.reason = reason;
  return target;
}

RunRecord run_of(const std::vector<TargetRecord>& targets) {
  RunRecord run;
  run.suite = "s";
  run.size = "1/4";
  run.started = "2026-01-01T00:00:00";
  run.wall_seconds = 3;
  run.renderers.push_back({});
  run.renderers[0].name = "r";
  run.renderers[0].version = "R 1.0";
  run.requirements = {{"M1", "A & B", {}}};
  run.targets = targets;
  for (const auto& target : targets) {
    JobRecord job;
    job.identity.id = target.jobs.front();
    job.cost.wall_seconds = 1.5;
    job.program.shell = "render " + target.target;
    run.jobs.push_back(job);
  }
  return run;
}

int count_of(const std::string& text, const std::string& what) {
  int count = 0;
  for (auto at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++count;
  return count;
}

std::string xml_of(Verdict verdict) { return junit_xml(run_of({target_of("101", verdict, "why")})); }

}  // namespace

TEST(Junit, EscapesWhatXmlCannotHold) {
  EXPECT_EQ(orbs::report::xml_text("<a & \"b\" 'c'>"), "&lt;a &amp; &quot;b&quot; &apos;c&apos;&gt;");
  EXPECT_EQ(orbs::report::xml_text("\x1b[0m\tx"), "\uFFFD[0m\tx");
  EXPECT_EQ(orbs::report::xml_text("\xc3\xa9 \xc3 \xff \xed\xa0\x80"),
            "\u00e9 \uFFFD \uFFFD \uFFFD\uFFFD\uFFFD");
}

// Checked against Jenkins' junit-10.xsd; GitLab and dorny/test-reporter show the body of <failure> alone.
TEST(Junit, HasATestCaseForEachTargetWithReasonAndDiagnosisInTheBody) {
  auto failed = target_of("101", Verdict::Fail, "too dark & wrong");
  failed.diagnosis = "upside down: then 40.0 dB";
  failed.remarks = {"bias: darker"};
  EXPECT_EQ(junit_xml(run_of({failed, target_of("102", Verdict::Pass, "")})),
            R"(<?xml version="1.0" encoding="UTF-8"?>
<testsuites name="orbs" tests="2" failures="1" errors="0" time="3.000">
  <testsuite name="s.r.M1" tests="2" failures="1" errors="0" skipped="0" time="3.000" timestamp="2026-01-01T00:00:00">
    <properties>
      <property name="title" value="A &amp; B"/>
      <property name="size" value="1/4"/>
      <property name="version" value="R 1.0"/>
    </properties>
    <testcase classname="s.r.M1" name="m1 101" time="1.500">
      <failure type="fail" message="fail: upside down: then 40.0 dB; too dark &amp; wrong">upside down: then 40.0 dB; too dark &amp; wrong
bias: darker
render 101</failure>
    </testcase>
    <testcase classname="s.r.M1" name="m1 102" time="1.500">
      <system-out>render 102</system-out>
    </testcase>
  </testsuite>
</testsuites>
)");
}

// Jenkins and GitLab tell test cases apart by class and name.
TEST(Junit, ASceneThatTwoCasesJudgeHasTwoTestCases) {
  auto other = target_of("101", Verdict::Fail, "dark");
  other.case_name = "m1-other";
  const auto text = junit_xml(run_of({target_of("101", Verdict::Pass, ""), other}));
  EXPECT_EQ(count_of(text, "<testcase classname=\"s.r.M1\" name=\"m1 101\""), 1);
  EXPECT_EQ(count_of(text, "<testcase classname=\"s.r.M1\" name=\"m1-other 101\""), 1);
  EXPECT_EQ(count_of(text, "<testsuite name="), 1);
}

TEST(Junit, TellsErrorsFromFailuresAndFromWhatIsNotSupported) {
  EXPECT_EQ(count_of(xml_of(Verdict::Crash), "<error type=\"crash\" message=\"crash: why\">why\n"), 1);
  EXPECT_EQ(count_of(xml_of(Verdict::Crash), "failures=\"0\" errors=\"1\""), 2);
  EXPECT_EQ(count_of(xml_of(Verdict::Unsupported), "<skipped type=\"unsupported\" message="), 1);
  EXPECT_EQ(count_of(xml_of(Verdict::Pass), "message="), 0);
  auto known = target_of("101", Verdict::Fail, "dark");
  known.expectation = Expectation::Known;
  known.expected = "another model";
  EXPECT_EQ(count_of(junit_xml(run_of({known})),
                     "<skipped type=\"known\" message=\"known: another model; dark\">another model; dark\n"),
            1);
  auto passed = target_of("101", Verdict::Pass, "");
  passed.expectation = Expectation::News;
  EXPECT_EQ(count_of(junit_xml(run_of({passed})), "<failure type=\"unexpected pass\" message="), 1);
}

// A CI server shows the remark of a test that passed; in a strict run it is a failure.
TEST(Junit, APassWithRemarksIsAFailureOfAStrictRunAlone) {
  auto target = target_of("101", Verdict::PassWithRemarks, "bias: brighter");
  EXPECT_EQ(count_of(junit_xml(run_of({target})), "<system-out>bias: brighter"), 1);
  EXPECT_EQ(count_of(junit_xml(run_of({target})), "<failure"), 0);
  target.expectation = Expectation::News;
  EXPECT_EQ(count_of(junit_xml(run_of({target})), "<failure type=\"pass with remarks\""), 1);
}
