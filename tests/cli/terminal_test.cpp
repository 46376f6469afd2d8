// What a user sees on the terminal while a run goes on, and what programs read instead.
#include "base/text.h"
#include "base/text_table.h"
#include "cli/sandbox.h"
#include "image/image_io.h"
#include "json/object_reader.h"
#include "results/record.h"

#include <algorithm>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

using namespace orbs;
using cli_tests::contains;
using cli_tests::Sandbox;

namespace {

std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

constexpr const char* kOrbs = ORBS_BINARY_WORD "/orbs";

}  // namespace

TEST(Terminal, ARunSaysWhatItWillDoAndEndsWithTheNextCommand) {
  const Sandbox sandbox;
  const auto first = sandbox.orbs({"run", "-r", "good", "-s", "grey"});
  EXPECT_TRUE(
      contains(first.text, "configuration: " + (sandbox.folder() / "configuration.json").string() + "\n"))
      << first.text;
  EXPECT_TRUE(
      contains(first.text, "suite t with good: 1 render; no earlier run here says how long they take"))
      << first.text;
  EXPECT_TRUE(contains(first.text, "next: " + shell_text({ORBS_BINARY_DIR "/orbs"}) + " serve outputs-"))
      << first.text;
  const auto second = sandbox.orbs({"run", "-r", "good", "-s", "grey,mirror"});
  EXPECT_TRUE(contains(second.text, "2 renders, about ")) << second.text;
  EXPECT_TRUE(contains(second.text, " s for 1 of them, the others have no recorded time")) << second.text;
}

TEST(Terminal, AConfigurationThatWasFoundElsewhereIsSaid) {
  const Sandbox sandbox;
  sandbox.write("deep/below/keep", "");
  const auto answer = sandbox.shell(fmt::format("cd deep/below && {} run -r good -s grey", kOrbs));
  EXPECT_EQ(answer.status, 0) << answer.text;
  EXPECT_TRUE(contains(answer.text, "configuration.json, which is not in this folder\n")) << answer.text;
}

TEST(Terminal, AnInterruptIsToldInOneLine) {
  const Sandbox sandbox;
  const auto answer = sandbox.orbs({"run", "-r", "interrupt,good", "-o", "out"});
  EXPECT_EQ(answer.status, 130);
  EXPECT_EQ(count_of(answer.text, "skipped;"), 1U) << answer.text;
  EXPECT_FALSE(contains(answer.text, "before its turn")) << answer.text;
  EXPECT_TRUE(contains(answer.text, "renders were skipped; what was finished stands above.")) << answer.text;
  EXPECT_TRUE(
      contains(answer.text, "next: " + shell_text({ORBS_BINARY_DIR "/orbs", "run", "--resume", "out"})))
      << answer.text;
}

TEST(Terminal, HasABarWithWhatIsRunning) {
  const Sandbox sandbox;
  const auto answer = sandbox.shell(fmt::format("TERM=xterm COLUMNS=80 script -qec {} /dev/null",
                                                shell_text({fmt::format("{} run -r good -s grey", kOrbs)})));
  EXPECT_TRUE(contains(answer.text, "[....................] 0/1: good grey (0 s)")) << answer.text;
  EXPECT_FALSE(contains(sandbox.orbs({"run", "-r", "good", "-s", "grey"}).text, "[...."))
      << "no terminal, no bar";
}

TEST(Terminal, NoLineOfTheHelpIsWiderThanTheTerminal) {
  const Sandbox sandbox;
  for (const char* command : {"", "run", "serve", "compare", "reference", "qualify"}) {
    const auto lines =
        split(sandbox.shell(fmt::format("COLUMNS=80 {} {} --help", kOrbs, command)).text, '\n');
    EXPECT_GE(lines.size(), 8U) << command;
    for (const auto& line : lines) EXPECT_LE(display_width(line), 80U) << command << ": " << line;
  }
}

TEST(Version, OfACommandThatFailsIsUnknownAndSaidOnce) {
  const Sandbox sandbox;
  sandbox.write("render", fmt::format("#!/bin/sh\n[ \"$1\" = --version ] || exec {} \"$@\"\n"
                                      "echo 'Traceback (most recent call last):'; exit 1\n",
                                      ORBS_BINARY_WORD "/orbs-fake-renderer"));
  ::chmod((sandbox.folder() / "render").c_str(), 0755);
  const auto answer = sandbox.orbs({"run", "-r", "good", "-e", "./render", "-o", "out"});
  EXPECT_EQ(count_of(answer.text, "good: version unknown: "), 1U) << answer.text;
  const auto version =
      results::read_job_file(sandbox.folder() / "out/good/grey/job.json").job.program.version;
  EXPECT_TRUE(version.starts_with("unknown: ") && version.ends_with("ended with exit code 1")) << version;
}

TEST(Visualize, IsTheLongNameOfView) {
  const Sandbox sandbox;
  EXPECT_EQ(sandbox.orbs({"run", "--visualize", "--dry-run", "-r", "good"}).status, 0);
  sandbox.write("configuration.json", cli_tests::configuration_with(R"("view": true)"));
  EXPECT_EQ(sandbox.orbs({"run", "--no-view", "-r", "good", "-s", "grey", "-o", "out"}).status, 0);
  EXPECT_TRUE(contains(sandbox.read("out/plan.json"), "\"view\": false"));
}

TEST(AsJson, ListDoctorAndCompareAreReadByPrograms) {
  const Sandbox sandbox;
  const auto list = json::parse("list", sandbox.orbs({"list", "cases", "--json"}).text);
  json::ObjectReader in(list);
  EXPECT_EQ(in.text("format"), "orbs-list/1");
  auto cases = in.objects("cases");
  ASSERT_EQ(cases.size(), 2U);
  EXPECT_EQ(cases[1].texts("targets"), (std::vector<std::string>{"mirror", "grey", "rest"}));

  const auto doctor = json::parse("doctor", sandbox.orbs({"doctor", "--json"}).text);
  json::ObjectReader report(doctor);
  EXPECT_EQ(report.text("format"), "orbs-doctor/1");
  EXPECT_EQ(report.objects("renderers")[0].text("version"), "fake renderer 7.8");

  const auto answer = sandbox.orbs({"compare", "references/grey.exr", "references/grey.exr", "--json"});
  EXPECT_EQ(answer.status, 0);
  const auto comparison = json::parse("compare", answer.text);
  json::ObjectReader numbers(comparison);
  EXPECT_EQ(numbers.text("format"), "orbs-comparison/1");
  EXPECT_GE(numbers.objects("metrics").size(), 5U);
}

TEST(Completion, OffersCommandsTheirOptionsAndTheirWords) {
  const Sandbox sandbox;
  const auto completed = [&](const std::string& words, int at) {
    return sandbox
        .shell(fmt::format("{} completion bash > c.sh && bash -c {}", kOrbs,
                           shell_text({fmt::format(". ./c.sh; COMP_WORDS=({}); COMP_CWORD={}; "
                                                   "_orbs; echo ${{COMPREPLY[*]}}",
                                                   words, at)})))
        .text;
  };
  EXPECT_EQ(completed("orbs ru", 1), "run\n");
  EXPECT_EQ(completed("orbs run --res", 2), "--resume\n");
  EXPECT_EQ(completed("orbs list sc", 2), "scenes\n");
  const auto value = [&](const std::string& words, int at) { return completed(kOrbs + (" " + words), at); };
  EXPECT_EQ(value("run --renderer goo", 3), "good\n");
  EXPECT_EQ(value("run -s mir", 3), "mirror\n");
  EXPECT_EQ(value("run --requirement M", 3), "M1 M3\n");
  EXPECT_EQ(value("run --size 1/", 3), "1/2 1/4 1/8\n");
  EXPECT_EQ(value("run --suite ''", 3), "t\n");
  EXPECT_EQ(value("compare --metric psnr_s", 3), "psnr_srgb8\n");
  EXPECT_EQ(value("stability --relation translate_m", 3), "translate_matrix\n");
  EXPECT_EQ(value("probe --side 1", 3), "\n");
  EXPECT_TRUE(contains(sandbox.orbs({"completion", "fish"}).text,
                       "complete -c orbs -n '__fish_seen_subcommand_from run' -l resume -d "));
  EXPECT_TRUE(sandbox.orbs({"completion", "zsh"}).text.starts_with("#compdef orbs\n"));
}

// Where a line is broken by hand, a narrower terminal breaks it twice.
TEST(Help, NoLineEndsWithinASentence) {
  const Sandbox sandbox;
  const auto check = [&](const std::string& words) {
    const auto text = sandbox.shell(fmt::format("{} {} --help", kOrbs, words)).text;
    auto lines = split(text, '\n');
    if (!words.empty()) lines.erase(lines.begin());  // what the command is for, no sentence
    for (const auto& line : lines) {
      if (line.empty() || line.front() == ' ' || line.starts_with("Usage:")) continue;
      EXPECT_TRUE(line.ends_with('.') || line.ends_with(':')) << words << ": " << line;
    }
  };
  check("");
  for (const char* command : {"run", "compare", "compare-runs", "history", "merge", "probe", "qualify",
                              "sensitivity", "cost", "stability", "effect-cost", "judge"})
    check(command);
}

TEST(Manual, OptionsStandWithTheirArguments) {
  const Sandbox sandbox;
  const auto page = sandbox.orbs({"manual"}).text;
  EXPECT_TRUE(contains(page, ".B \\-j, \\-\\-jobs \\fINUMBER\\fR\n")) << page.substr(0, 2000);
  EXPECT_TRUE(contains(page, ".B \\-\\-json\n")) << page.substr(0, 2000);
  const auto tracer = sandbox.shell(ORBS_BINARY_WORD "/orbs-tracer --manual");
  EXPECT_EQ(tracer.status, 0);
  EXPECT_TRUE(tracer.text.starts_with(".TH ORBS\\-TRACER 1 ")) << tracer.text.substr(0, 200);
  EXPECT_TRUE(contains(tracer.text, "\\-\\-spp \\fI")) << tracer.text;
}

TEST(Bootstrap, HelpOfRunBuildsNothing) {
  const Sandbox sandbox;
  const auto answer = sandbox.shell(ORBS_SOURCE_WORD "/bootstrap run --help");
  EXPECT_EQ(answer.status, 0) << answer.text;
  EXPECT_TRUE(contains(answer.text, "--resume")) << answer.text;
  EXPECT_FALSE(contains(answer.text, "bootstrap: ")) << answer.text;
}
