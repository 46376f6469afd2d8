// The program as a user runs it, with a renderer that fails on demand.
#include "base/text.h"
#include "cli/sandbox.h"
#include "image/image_io.h"
#include "json/document.h"

#include <algorithm>
#include <cstdlib>

#include <gtest/gtest.h>
#include <sys/stat.h>

using orbs::cli_tests::configuration_with;
using orbs::cli_tests::contains;
using orbs::cli_tests::Sandbox;

namespace {

// Text of the member of results.json's first image, or of any other object that has it first.
std::string member(const std::string& text, const std::string& name) {
  const auto at = text.find("\"" + name + "\": ");
  if (at == std::string::npos) return "absent";
  const auto begin = at + name.size() + 4;
  return text.substr(begin, text.find_first_of(",\n", begin) - begin);
}

}  // namespace

TEST(Run, AGoodRendererPassesWithStatusZeroAndATable) {
  const Sandbox sandbox;
  const auto answer = sandbox.orbs({"run", "-r", "good", "-o", "out"});
  EXPECT_EQ(answer.status, 0) << answer.text;
  EXPECT_TRUE(contains(answer.text, "M1  Grey            inf pass")) << answer.text;
  EXPECT_TRUE(contains(answer.text, "good  declared G5/M8 \u00b7 measured M3-(2)")) << answer.text;
  for (const char* file :
       {"results.json", "results.csv", "junit.xml", "good/grey/result.exr", "good/grey/log.txt",
        "good/grey/job.json", "good/grey/result.png", "good/rest/result.exr", "good/v1.5/result.exr"})
    EXPECT_TRUE(sandbox.has(std::string("out/") + file)) << file;
  // Maps of the error follow from the images: they would be most of the size of a run.
  EXPECT_FALSE(sandbox.has("out/good/grey/error-l1.exr"));
}

TEST(Run, AWrongImageFailsWithStatusOne) {
  const Sandbox sandbox;
  const auto answer = sandbox.orbs({"run", "-v", "-r", "dark", "-c", "m1_grey"});
  EXPECT_EQ(answer.status, 1);
  EXPECT_TRUE(contains(answer.text, "psnr_srgb8 is 12.01 dB, at least 35 is needed")) << answer.text;
}

TEST(Run, AProgramThatCannotBeExecutedIsACrashAndNoException) {
  const Sandbox sandbox;
  sandbox.write("text", "no program");
  ::chmod((sandbox.folder() / "text").c_str(), 0755);
  const auto answer = sandbox.orbs({"run", "-r", "good", "-e", "./text", "-s", "grey"});
  EXPECT_EQ(answer.status, 1);
  EXPECT_TRUE(contains(answer.text, "could not start: Exec format error")) << answer.text;
}

TEST(Run, AMissingReferenceIsAFailure) {
  const Sandbox sandbox;
  std::filesystem::remove(sandbox.folder() / "references" / "grey.exr");
  const auto answer = sandbox.orbs({"run", "-r", "good", "-s", "grey"});
  EXPECT_EQ(answer.status, 1);
  EXPECT_TRUE(contains(answer.text, "missing reference")) << answer.text;
}

TEST(Run, MuchOutputIsCutAndDoesNotStopTheRenderer) {
  const Sandbox sandbox;
  EXPECT_EQ(sandbox.orbs({"run", "-r", "much", "-s", "grey", "-o", "out"}).status, 0);
  const auto log = sandbox.read("out/much/grey/log.txt");
  EXPECT_LT(log.size(), 1100000U);
  EXPECT_TRUE(contains(log, "bytes left out"));
  EXPECT_TRUE(contains(log, "fake: render_seconds 0.25"));  // the end is kept
}

TEST(Run, ErrorsOfTheRendererStandInItsLog) {
  const Sandbox sandbox;
  sandbox.orbs({"run", "-r", "complain", "-s", "grey", "-o", "out"});
  EXPECT_TRUE(contains(sandbox.read("out/complain/grey/log.txt"), "something is odd"));
}

TEST(Run, RecordsWhatMadeAnImageAndWhatItCost) {
  const Sandbox sandbox;
  sandbox.orbs({"run", "-r", "good", "-s", "grey", "-o", "out", "--threads", "3", "--seed", "9",
                "--spp-scale", "0.5"});
  const auto json = sandbox.read("out/good/grey/job.json");
  EXPECT_NO_THROW(orbs::json::parse("job.json", json));
  EXPECT_EQ(member(json, "renderer"), "\"good\"");
  EXPECT_EQ(member(json, "version"), "\"fake renderer 7.8\"");
  EXPECT_EQ(member(json, "spp"), "4");
  EXPECT_EQ(member(json, "seed"), "9");
  EXPECT_EQ(member(json, "threads"), "3");
  EXPECT_EQ(member(json, "render_seconds"), "0.25");
  EXPECT_GT(std::stod(member(json, "wall_seconds")), 0);
  EXPECT_GT(std::stod(member(json, "cpu_seconds")), 0);
  EXPECT_GT(std::stod(member(json, "peak_rss_bytes")), 1e6);
  EXPECT_GE(std::stod(member(json, "load")), 0);
  for (const char* fact : {"cpu", "system", "compiler"}) EXPECT_GT(member(json, fact).size(), 2U) << fact;
  EXPECT_TRUE(contains(json, R"("--threads", "3", "--spp", "4", "--seed", "9")")) << json;
}

TEST(Run, ARendererMayTakeItsOwnNumberOfSamples) {
  const Sandbox sandbox;
  sandbox.add_to_good(R"(, "spp_scale": 2)");
  sandbox.orbs({"run", "-r", "good", "-s", "mirror", "-o", "out"});
  EXPECT_EQ(member(sandbox.read("out/good/mirror/job.json"), "spp"), "16");
}

TEST(Run, TheSameRenderHasTheSameIdInEveryRun) {
  const Sandbox sandbox;
  sandbox.orbs({"run", "-r", "good", "-s", "grey", "-o", "a"});
  sandbox.orbs({"run", "-r", "good", "-o", "b"});
  EXPECT_EQ(member(sandbox.read("a/good/grey/job.json"), "id"),
            member(sandbox.read("b/good/grey/job.json"), "id"));
  EXPECT_NE(member(sandbox.read("b/good/grey/job.json"), "id"),
            member(sandbox.read("b/good/mirror/job.json"), "id"));
}

TEST(Run, AResultDoesNotDependOnTheNumberOfJobs) {
  const Sandbox sandbox;
  EXPECT_EQ(sandbox.orbs({"run", "-r", "good,dark,nan", "-o", "a", "-j", "1", "--threads", "1"}).status, 1);
  EXPECT_EQ(sandbox.orbs({"run", "-r", "good,dark,nan", "-o", "b", "-j", "4", "--threads", "1"}).status, 1);
  const auto csv = [&](const std::string& folder) {
    // All but the last columns: what it cost, the name of the image, and the command in its folder.
    std::string out;
    for (auto line : orbs::split(sandbox.read(folder + "/results.csv"), '\n')) {
      for (int column = 0; column < 6; ++column) line.erase(std::min(line.rfind(','), line.size()));
      out += line + "\n";
    }
    return out;
  };
  EXPECT_EQ(csv("a"), csv("b"));
}

TEST(Run, AfterAnInterruptItEndsTheRendererAndKeepsWhatIsFinished) {
  const Sandbox sandbox;
  const auto answer = sandbox.orbs({"run", "-r", "good,interrupt", "-c", "m1_grey", "-o", "out"});
  EXPECT_EQ(answer.status, 130) << answer.text;
  const auto json = sandbox.read("out/results.json");
  EXPECT_EQ(member(json, "interrupted"), "true");
  EXPECT_EQ(member(sandbox.read("out/good/grey/job.json"), "verdict"), "\"pass\"");
  EXPECT_FALSE(sandbox.has("out/interrupt/grey")) << "what was interrupted is not done";
  EXPECT_TRUE(contains(json, "was ended because the run was interrupted"));
  EXPECT_TRUE(contains(answer.text, "The run was interrupted")) << answer.text;
}

TEST(Run, PassesOnOnlyTheAllowedEnvironment) {
  const Sandbox sandbox;
  ::setenv("ORBS_TEST_SECRET", "hidden", 1);
  sandbox.orbs({"run", "-r", "environment", "-s", "grey", "-o", "out"});
  const auto log = sandbox.read("out/environment/grey/log.txt");
  EXPECT_TRUE(contains(log, "LC_ALL=C.UTF-8\n"));
  EXPECT_FALSE(contains(log, "ORBS_TEST_SECRET"));
}

TEST(Run, TwoStartsInTheSameSecondHaveTwoFolders) {
  const Sandbox sandbox;
  for (int i = 0; i < 2; ++i) EXPECT_EQ(sandbox.orbs({"run", "-r", "good", "-s", "grey"}).status, 0);
  EXPECT_EQ(sandbox.runs().size(), 2U);
}

TEST(Run, AnotherProgramCanStandInForAConfiguredRenderer) {
  const Sandbox sandbox;
  std::filesystem::create_symlink(ORBS_BINARY_DIR "/orbs-fake-renderer", sandbox.folder() / "mine");
  const auto answer = sandbox.orbs({"run", "-r", "good", "-e", "./mine", "-s", "grey", "-o", "out"});
  EXPECT_EQ(answer.status, 0) << answer.text;
  EXPECT_TRUE(contains(sandbox.read("out/good/grey/job.json"),
                       "\"argv\": [\"" + (sandbox.folder() / "mine").string()));
}

// So that the table fills evenly while a run goes on.
TEST(Run, BeginsWithOneSceneOfEachRequirementByEveryRenderer) {
  const Sandbox sandbox;
  const auto answer = sandbox.orbs({"run", "-r", "good,dark", "--dry-run"});
  std::vector<std::string> jobs;
  for (const auto& line : orbs::split(answer.text, '\n'))
    for (const char* renderer : {"  good  ", "  dark  "})
      if (const auto at = line.find(renderer); at != std::string::npos) jobs.push_back(line.substr(at + 2));
  EXPECT_EQ(jobs, (std::vector<std::string>{"good  grey", "dark  grey", "good  mirror", "dark  mirror",
                                            "good  v1.5", "dark  v1.5"}))
      << answer.text;
}

TEST(Run, ADryRunPrintsTheCommandsAndTouchesNothing) {
  const Sandbox sandbox;
  const auto answer = sandbox.orbs({"run", "-r", "good", "-c", "m1_grey", "--dry-run", "-o", "out"});
  EXPECT_EQ(answer.status, 0);
  EXPECT_TRUE(contains(answer.text, orbs::shell_text({ORBS_BINARY_DIR "/orbs-fake-renderer"}) +
                                        " --mode good --output OUTPUT/good/grey/result.exr --scene "
                                        "OUTPUT/good/grey/scene.json"))
      << answer.text;
  EXPECT_FALSE(sandbox.has("out"));
}

TEST(Run, UndeclaredRequirementsAreUnsupportedWithTheReasonAndNoFailure) {
  const Sandbox sandbox;
  auto text = configuration_with("");
  const std::string declares = "\"declares\": \"G5/M8\"";
  text.replace(
      text.find(declares), declares.size(),
      R"("declares": "G5/M2", "known_limits": [{"requirements": ["M3"], "reason": "it has no mirrors"}])");
  sandbox.write("configuration.json", text);
  const auto answer = sandbox.orbs({"run", "-r", "good"});
  EXPECT_EQ(answer.status, 0) << answer.text;
  EXPECT_TRUE(contains(answer.text, "good does not declare M3: it has no mirrors")) << answer.text;
}

TEST(Run, WhereNothingIsJudgedItIsNoSuccess) {
  const Sandbox sandbox;
  auto text = configuration_with("");
  const std::string declares = "\"declares\": \"G5/M8\"";
  sandbox.write("configuration.json",
                text.replace(text.find(declares), declares.size(), R"("declares": "G5")"));
  const auto answer = sandbox.orbs({"run", "-r", "good"});
  EXPECT_EQ(answer.status, 2) << answer.text;
  EXPECT_TRUE(contains(answer.text, "orbs: nothing was judged: every target is unsupported")) << answer.text;
}

// The page needs nothing but the run's folder: not the suite, not the references of this machine.
TEST(Run, LeavesAFolderThatCanBeShownOnItsOwn) {
  const Sandbox sandbox;
  EXPECT_EQ(sandbox.orbs({"run", "-r", "good,nan", "-o", "out"}).status, 1);
  for (const char* file : {"references/grey.exr", "references/mirror.exr", "references/rest.exr"})
    EXPECT_TRUE(sandbox.has(std::string("out/") + file)) << file;
  EXPECT_FALSE(sandbox.has("out/run.lock"));
  const auto json = sandbox.read("out/results.json");
  EXPECT_EQ(member(json, "finished"), "true");
  EXPECT_TRUE(contains(json, R"("reference_image": "references/rest.exr")")) << json;
  EXPECT_TRUE(contains(json, R"("image": "nan/grey/result.exr")")) << "NaN cannot be judged, but looked at";
  EXPECT_TRUE(contains(json, R"("title": "Mirror & co")"));
}

// As judged: the reference that another scene lends, and none where the provenance says that it is another's.
TEST(Run, LeavesTheReferencesThatItWasJudgedBy) {
  const Sandbox sandbox;
  auto text = sandbox.read("cases/m1_grey/case.json");
  const std::string borrows = R"("name": "v1.5", )";
  sandbox.write("cases/m1_grey/case.json",
                text.replace(text.find(borrows), borrows.size(), borrows + R"("reference": "grey", )"));
  std::filesystem::remove(sandbox.folder() / "references/v1.5.exr");
  auto other = orbs::image::read_image(sandbox.folder() / "references/mirror.exr");
  other.attributes["orbs.scene_hash"] = "0123456789abcdef";
  orbs::image::write_exr(other, sandbox.folder() / "references/mirror.exr");
  sandbox.orbs({"run", "-r", "good", "-o", "out"});
  EXPECT_TRUE(sandbox.has("out/references/v1.5.exr"));
  EXPECT_FALSE(sandbox.has("out/references/mirror.exr"));
}
