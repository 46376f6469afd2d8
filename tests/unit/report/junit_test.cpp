// JUnit XML as the parsers of CI servers read it.
#include "report/junit.h"

#include "base/text.h"

#include <cstdint>
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
  EXPECT_EQ(orbs::report::xml_text("a\xef\xbf\xbe"
                                   "b\xef\xbf\xbf"),
            "a\uFFFDb\uFFFD");
  EXPECT_EQ(orbs::report::xml_text("\uFFFD\uFFFC\U0001FFFE"), "\uFFFD\uFFFC\U0001FFFE");
}

// A parser of its own for the set of XML 1.0: every character that a renderer could say in its last words.
TEST(Junit, HoldsNoCharacterThatXmlHasNot) {
  const auto is_of_xml = [](char32_t c) {
    return c == 0x9 || c == 0xA || c == 0xD || (c >= 0x20 && c <= 0xD7FF) || (c >= 0xE000 && c <= 0xFFFD) ||
           (c >= 0x10000 && c <= 0x10FFFF);
  };
  std::string all;
  for (char32_t c = 0; c < 0x11000; ++c) {
    if (c < 0x80) {
      all += static_cast<char>(c);
    } else if (c < 0x800) {
      all += static_cast<char>(0xC0 | c >> 6);
      all += static_cast<char>(0x80 | (c & 0x3F));
    } else {
      if (c >= 0x10000) all += static_cast<char>(0xF0 | c >> 18);
      all += static_cast<char>(c >= 0x10000 ? 0x80 | (c >> 12 & 0x3F) : 0xE0 | c >> 12);
      all += static_cast<char>(0x80 | (c >> 6 & 0x3F));
      all += static_cast<char>(0x80 | (c & 0x3F));
    }
  }
  const auto text = orbs::report::xml_text(all);
  for (std::size_t i = 0; i < text.size();) {
    const auto length = orbs::utf8_length(std::string_view(text).substr(i));
    ASSERT_GT(length, 0U) << i;
    char32_t c = static_cast<unsigned char>(text[i]) & (length == 1 ? 0x7FU : 0x3FU >> (length - 1));
    for (std::size_t k = 1; k < length; ++k) c = c << 6 | (static_cast<unsigned char>(text[i + k]) & 0x3FU);
    EXPECT_TRUE(is_of_xml(c)) << std::hex << static_cast<std::uint32_t>(c);
    i += length;
  }
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
