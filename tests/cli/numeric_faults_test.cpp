// The hard cases of the suite stability catch mistakes of arithmetic, which orbs-faulty-tracer makes on
// demand. docs/reports/numeric-faults.csv holds which cases catch which; the test Measured writes it.
#include "base/files.h"
#include "base/text.h"
#include "cli/sandbox.h"
#include "image/image_io.h"
#include "registry/cases.h"
#include "results/record.h"
#include "structure/documentation.h"
#include "tracer/numeric_fault.h"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <set>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

using namespace orbs;
using cli_tests::Sandbox;

namespace {

namespace fs = std::filesystem;

const fs::path kRoot = ORBS_SOURCE_DIR;
const auto kTable = kRoot / "docs/reports/numeric-faults.csv";
constexpr const char* kNone = "none";

// By the name of the fault, the scenes whose verdict is a failure.
using Caught = std::map<std::string, std::vector<std::string>>;

// All that are measured: those of the arithmetic, and two of orbs-tracer itself.
std::map<std::string, std::string> faults() {
  std::map<std::string, std::string> all{
      {"normals-by-matrix", "vertex normals are mapped by the matrix of an instance"},
      {"no-mis-weight", "light sampling and BSDF sampling both count in full"}};
  for (const auto& one : tracer::kNumericFaults) all.emplace(one.name, one.what);
  return all;
}

std::set<std::string> hard_scenes() {
  std::set<std::string> names;
  for (const auto& one_case : registry::load_cases(
           {"stability", kRoot / "data/cases/stability", kRoot / "data/references/stability", {}}))
    for (const auto& scene : one_case.scenes) names.insert(scene.name);
  return names;
}

Caught read_table() {
  Caught caught;
  for (const auto& line : split(read_file(kTable), '\n')) {
    if (line.empty() || line.starts_with("fault,")) continue;
    const auto comma = line.find(',');
    auto& scenes = caught[std::string(line.substr(0, comma))];
    for (const auto& scene : split(line.substr(comma + 1), ' '))
      if (!scene.empty()) scenes.emplace_back(scene);
  }
  return caught;
}

// The suite, and one renderer for each fault, called as it, and one without.
void write_configuration(const Sandbox& sandbox) {
  std::vector<std::string> entries;
  const auto add = [&](const std::string& name, const std::string& more) {
    entries.push_back(fmt::format(
        R"entry({{"name": "{}", "executable": "{{build}}/orbs-faulty-tracer", "declares": "G5/M8/L4/A4/S7/I2/B9/C5/D6/N5",
  "plugins": ["{{build}}/plugins/saddle.so"], "limits": {{"cpu_seconds": 1000}},
  "render_seconds": {{"pattern": "^orbs: render_seconds ([0-9.]+)"}},
  "command": ["{{executable}}", "--plugin={{plugin}}", "{{scene}}", "-o", "{{output}}", "--spp", "{{spp}}",
              "--seed", "{{seed}}", "--threads", "{{threads}}", "--bad-samples", "count"{}]}})entry",
        name, more));
  };
  add(kNone, "");
  for (const auto& [name, what] : faults()) add(name, fmt::format(R"(, "--fault", "{}")", name));
  sandbox.write("configuration.json", fmt::format(R"({{"format": "orbs-configuration/1", "stands_alone": true,
"defaults": {{"suite": "stability"}}, "suites": [{{"name": "stability", "cases": "{0}/data/cases/stability",
"references": "{0}/data/references/stability"}}], "renderers": [{1}]}})",
                                                  kRoot.string(), fmt::join(entries, ",\n")));
}

using OneOf = bool (*)(results::Verdict);

// By a wrong image, that is: another machine might be done before a timeout, and a crash can have other
// reasons.
bool is_caught(results::Verdict verdict) {
  return results::kind_of(verdict) == results::VerdictKind::WrongImage;
}

bool has_not_passed(results::Verdict verdict) { return !results::passes(verdict); }

// The scenes whose verdict is one of those; all scenes are rendered where none is named.
std::vector<std::string> scenes_with(const Sandbox& sandbox,
                                     OneOf wanted,
                                     const std::string& fault,
                                     const std::vector<std::string>& scenes) {
  std::vector<std::string> words{"run", "-q", "-r", fault, "-o", "out-" + fault};
  if (!scenes.empty()) words.insert(words.end(), {"-s", fmt::format("{}", fmt::join(scenes, ","))});
  const auto answer = sandbox.orbs(words);
  const auto file = sandbox.folder() / ("out-" + fault) / "results.json";
  if (!no_file_problem(file).empty()) throw std::runtime_error(answer.text);
  std::vector<std::string> found;
  for (const auto& target : results::read_results_file(file).targets)
    if (wanted(target.verdict)) found.push_back(target.target);
  return found;
}

std::string joined(const std::vector<std::string>& names, const char* quote = "") {
  std::vector<std::string> quoted;
  for (const auto& name : names) quoted.push_back(quote + name + quote);
  return fmt::format("{}", fmt::join(quoted, quote[0] == '\0' ? " " : ", "));
}

std::vector<std::string> uncaught_scenes(const Caught& table) {
  auto left = hard_scenes();
  for (const auto& [fault, scenes] : table)
    for (const auto& scene : scenes) left.erase(scene);
  return {left.begin(), left.end()};
}

// As few pairs as hold every fault and every scene that catches one.
Caught few_pairs(const Caught& table) {
  Caught few;
  std::set<std::string> done;
  for (const auto& [fault, scenes] : table) {
    if (scenes.empty()) continue;
    const auto fresh =
        std::find_if(scenes.begin(), scenes.end(), [&](const auto& s) { return !done.contains(s); });
    const auto& chosen = fresh == scenes.end() ? scenes.front() : *fresh;
    few[fault].push_back(chosen);
    done.insert(chosen);
  }
  for (const auto& [fault, scenes] : table)
    for (const auto& scene : scenes)
      if (done.insert(scene).second) few[fault].push_back(scene);
  return few;
}

// The first of them, and how many more there are.
std::string shortened(const std::vector<std::string>& scenes) {
  constexpr std::size_t kMost = 6;
  if (scenes.empty()) return "no case";
  const std::vector<std::string> first(scenes.begin(), scenes.begin() + std::min(scenes.size(), kMost));
  const auto left = scenes.size() - first.size();
  return joined(first, "`") + (left > 0 ? fmt::format(" and {} more", left) : "");
}

std::string table_text(const Caught& table) {
  std::string text = "| fault | a renderer with it | caught by |\n|---|---|---|\n";
  for (const auto& [fault, what] : faults())
    text += fmt::format("| `{}` | {} | {} |\n", fault, what, shortened(table.at(fault)));
  const auto left = uncaught_scenes(table);
  text += fmt::format("\n{}\n", left.empty()
                                    ? "Each case of the suite catches one of them at least."
                                    : "No fault of the table makes these fail: " + joined(left, "`") + ".");
  return text;
}

}  // namespace

// orbs-tracer has nothing of them: no name, no switch, and the images of a program that has them and makes
// none.
TEST(NumericFaults, AreNotInTheTracer) {
  const Sandbox sandbox;
  const auto of_tracer = read_file(fs::path(ORBS_BINARY_DIR) / "orbs-tracer");
  const auto of_tests = read_file(fs::path(ORBS_BINARY_DIR) / "orbs-faulty-tracer");
  std::vector<std::string> words{"active_fault"};  // the switch, as a symbol
  for (const auto& one : tracer::kNumericFaults) words.emplace_back(one.name);
  for (const auto& word : words) {
    EXPECT_EQ(of_tracer.find(word), std::string::npos) << word;
    EXPECT_NE(of_tests.find(word), std::string::npos) << word;
  }
  const auto render = [&](const std::string& program, const std::string& more) {
    return sandbox.shell(
        fmt::format("{}/{} {}/data/bench/cornell-box.json -o {}.exr --spp 4 --width 32 --height 32 {}",
                    ORBS_BINARY_WORD, program, ORBS_SOURCE_WORD, program, more));
  };
  EXPECT_EQ(render("orbs-tracer", "--fault no-ray-offset").status, 2);
  ASSERT_EQ(render("orbs-tracer", "").status, 0);
  ASSERT_EQ(render("orbs-faulty-tracer", "").status, 0);
  EXPECT_EQ(image::read_image(sandbox.folder() / "orbs-tracer.exr").pixels,
            image::read_image(sandbox.folder() / "orbs-faulty-tracer.exr").pixels);
}

// Every fault, and every hard case, once. Without a fault the first case of each passes.
TEST(NumericFaults, AreCaughtByTheHardCases) {
  const Sandbox sandbox;
  write_configuration(sandbox);
  std::set<std::string> controls;
  for (const auto& [fault, scenes] : few_pairs(read_table())) controls.insert(scenes.front());
  EXPECT_EQ(joined(scenes_with(sandbox, has_not_passed, kNone, {controls.begin(), controls.end()})), "");
  for (const auto& [fault, scenes] : few_pairs(read_table())) {
    auto caught = scenes_with(sandbox, is_caught, fault, scenes);
    for (const auto& scene : scenes)
      EXPECT_NE(std::find(caught.begin(), caught.end(), scene), caught.end())
          << fault << " is not caught by " << scene;
  }
}

TEST(NumericFaults, TheTableHasAllOfThem) {
  const auto table = read_table();
  std::set<std::string> names;
  for (const auto& [fault, scenes] : table) names.insert(fault);
  std::set<std::string> wanted;
  for (const auto& [fault, what] : faults()) wanted.insert(fault);
  EXPECT_EQ(names, wanted);
  const auto known = hard_scenes();
  for (const auto& [fault, scenes] : table)
    for (const auto& scene : scenes) EXPECT_TRUE(known.contains(scene)) << scene;
  EXPECT_EQ(
      structure::check_generated_part(kRoot / "docs/reference/known.md", "numeric faults", table_text(table)),
      "");
}

// With ORBS_MEASURE_FAULTS in the environment: all faults on all hard cases, a quarter of an hour of
// processor time. Without a fault the same program must pass.
TEST(NumericFaults, Measured) {
  if (std::getenv("ORBS_MEASURE_FAULTS") == nullptr) GTEST_SKIP() << "ORBS_MEASURE_FAULTS is not set";
  const Sandbox sandbox;
  write_configuration(sandbox);
  EXPECT_EQ(joined(scenes_with(sandbox, has_not_passed, kNone, {})), "");
  std::string text = "fault,caught by\n";
  for (const auto& [fault, what] : faults()) {
    auto caught = scenes_with(sandbox, is_caught, fault, {});
    std::sort(caught.begin(), caught.end());
    text += fmt::format("{},{}\n", fault, joined(caught));
    write_file(kTable, text);
  }
}
