// What a faulty renderer gets: never a pass, never a wait without end, and the others go on.
#include "cli/sandbox.h"
#include "image/image_io.h"
#include "json/object_reader.h"
#include "results/record.h"

#include <csignal>

#include <gtest/gtest.h>

using namespace orbs;
using cli_tests::Sandbox;

namespace {

// One line of the table: what is wrong with the renderer, its verdict, and a part of the reason.
struct Fault {
  const char* mode;
  const char* verdict;
  const char* reason;
};

constexpr Fault kFaults[]{
    {"segfault", "crash", "was killed by SIGSEGV"},
    {"abort", "crash", "was killed by SIGABRT"},
    {"exit3", "crash", "ended with exit code 3; its last words: fake: cannot find the sun"},
    {"exit3-after-image", "crash", "ended with exit code 3"},
    {"hang", "timeout", "was ended after its time limit of 0.3 s"},
    {"ignore-term", "timeout", "was ended after its time limit of 0.3 s"},
    {"hang-with-child", "timeout", "was ended after its time limit of 4 s"},
    {"burn", "timeout", "was ended after 0.3 s of processor time, its limit"},
    {"leak", "out of memory", "was ended because it took more than its 200 MB of memory"},
    {"leak-to-memfd", "out of memory", "was ended because it took more than its 200 MB of memory"},
    {"main-thread-ends", "timeout", "was ended after its time limit of 0.3 s"},
    {"main-thread-ends-leak", "out of memory", "was ended because it took more than its 200 MB of memory"},
    {"fill-file", "crash", "was ended because it wrote more than its 4 MB of files"},
    {"fill-files", "crash", "was ended because it wrote more than its 4 MB of files"},
    {"nothing", "no output", "wrote no result.exr"},
    {"elsewhere", "no output", "result.exr is no file of its own but a symbolic link"},
    {"garbage", "unreadable", "result.exr"},
    {"empty", "unreadable", "result.exr is empty"},
    {"half", "unreadable", "result.exr"},
    {"old", "stale", "result.exr is older than its render"},
    {"replace-own-folder", "no output", "wrote no result.exr"},
    {"coloured", "crash", "ended with exit code 3; its last words: fake: \uFFFD cannot read sun.txt"},
    {"other-scene", "stale", "result.exr is an image of another scene"},
    {"other-job", "stale", "result.exr is of another render"},
    {"wrong-size", "wrong size", "result.exr is 6 x 8 pixels, expected 12 x 8"},
    {"wrong-channels", "wrong channels", "result.exr has the channels Y, expected R, G, B"},
    {"nan", "invalid pixels",
     "1 pixels are NaN, 0 infinite, 0 negative; the first is (3, 2), channel G, value nan; all lie in "
     "[3,2,4,3]"},
    {"infinite", "invalid pixels",
     "0 pixels are NaN, 1 infinite, 0 negative; the first is (5, 1), channel R"},
    {"negative", "invalid pixels",
     "0 pixels are NaN, 0 infinite, 2 negative; the first is (4, 3), channel B, value -0.001; all lie in "
     "[4,3,7,6]"},
    {"dark", "fail", "psnr_srgb8 is 12.01 dB, at least 35 is needed"},
    // No fault of the image, and no harm to the run.
    {"leave-child", "pass", ""},
    {"main-thread-ends-daemon", "pass", ""},
    {"shared-pages", "pass", ""},
    {"litter", "pass", ""},
    {"noisy-litter", "inconclusive", "noise"},
    {"much", "pass", ""},
    {"read-input", "pass", ""}};

results::TargetRecord image_of(const Sandbox& sandbox, const std::string& renderer) {
  const auto file = results::read_job_file(sandbox.folder() / "out" / renderer / "grey/job.json");
  return file.targets.at(0);
}

std::vector<std::string> run_of(const std::string& renderers) {
  return {"run", "-r", renderers, "-s", "grey", "-c", "m1_grey", "-o", "out"};
}

image::Image gradient() {
  auto image = image::make_image(12, 8, {"R", "G", "B"});
  for (std::size_t i = 0; i < image.pixels.size(); ++i) image.pixels[i] = 0.5F + 1e-4F * float(i % 7);
  return image;
}

}  // namespace

TEST(Faults, EachGetsItsVerdictAndTheOthersGoOn) {
  const Sandbox sandbox;
  std::string renderers = "good";
  for (const auto& fault : kFaults) renderers += std::string(",") + fault.mode;
  auto words = run_of(renderers);
  words.insert(words.end(), {"-j", "4"});
  const auto answer = sandbox.orbs(words);
  EXPECT_EQ(answer.status, 1) << answer.text;
  for (const auto& fault : kFaults) {
    const auto image = image_of(sandbox, fault.mode);
    EXPECT_EQ(verdict_name(image.verdict), fault.verdict) << fault.mode << ": " << image.reason;
    EXPECT_NE(image.reason.find(fault.reason), std::string::npos) << fault.mode << ": " << image.reason;
  }
  EXPECT_EQ(image_of(sandbox, "good").verdict, results::Verdict::Pass);
  EXPECT_FALSE(sandbox.has("out/.unfinished"));
  EXPECT_EQ(sandbox.read("out/results.csv").find('\033'), std::string::npos);
  EXPECT_EQ(sandbox.read("out/results.csv").find("/.unfinished/"), std::string::npos);
}

TEST(Faults, NoChildOutlivesItsRenderNotEvenInAnotherSession) {
  const Sandbox sandbox;
  for (const char* mode : {"hang-with-child", "leave-child", "main-thread-ends-daemon"}) {
    sandbox.orbs(run_of(mode));
    const auto file = std::string("out/") + mode + "/grey/child.txt";
    const auto child = static_cast<pid_t>(std::stoi(sandbox.read(file)));
    EXPECT_NE(::kill(child, 0), 0) << mode;
    std::filesystem::remove_all(sandbox.folder() / "out");
  }
}

// Nobody gives up on it: the supervisor would after 10 s.
TEST(Faults, ThreadsThatOutliveTheMainThreadAreEndedAtOnce) {
  const Sandbox sandbox;
  sandbox.orbs(run_of("main-thread-ends"));
  const auto file = results::read_job_file(sandbox.folder() / "out/main-thread-ends/grey/job.json");
  EXPECT_EQ(file.job.end.signal, "SIGTERM");
  EXPECT_LT(file.job.cost.wall_seconds, 10);
}

TEST(Faults, OneColourAllOverIsAFaultUnlessTheReferenceHasOneToo) {
  const Sandbox sandbox;
  image::write_exr(gradient(), sandbox.folder() / "references/grey.exr");
  EXPECT_EQ(sandbox.orbs(run_of("good")).status, 1);
  const auto image = image_of(sandbox, "good");
  EXPECT_EQ(image.verdict, results::Verdict::ConstantImage);
  EXPECT_GT(image.measures.size(), 0U) << "it passes its gate all the same";
}

TEST(Faults, NegativeValuesAreCountedWhereTheCaseAllowsThem) {
  const Sandbox sandbox;
  auto text = sandbox.read("cases/m1_grey/case.json");
  sandbox.write("cases/m1_grey/case.json",
                text.insert(text.rfind('}'), R"(, "negative_values": "colours outside the gamut")"));
  EXPECT_EQ(sandbox.orbs(run_of("negative")).status, 1);
  const auto image = image_of(sandbox, "negative");
  EXPECT_EQ(image.verdict, results::Verdict::Fail);  // two of 96 pixels are black
  ASSERT_FALSE(image.measures.empty());
  EXPECT_EQ(image.measures.front().name, "negative_pixels");
  EXPECT_EQ(image.measures.front().value, 2);
}

// Another case that looks at the same render does not become lenient by that.
TEST(Faults, WhatOneCaseAllowsIsNotAllowedInAnother) {
  const Sandbox sandbox;
  auto text = sandbox.read("cases/m1_grey/case.json");
  sandbox.write("cases/m1_grey/case.json",
                text.insert(text.rfind('}'), R"(, "negative_values": "colours outside the gamut")"));
  sandbox.orbs({"run", "-r", "negative", "-s", "grey", "-o", "out"});
  const auto file = results::read_job_file(sandbox.folder() / "out/negative/grey/job.json");
  ASSERT_EQ(file.targets.size(), 2U);
  EXPECT_EQ(file.targets[0].verdict, results::Verdict::Fail);
  EXPECT_EQ(file.targets[1].verdict, results::Verdict::InvalidPixels);
}

TEST(Faults, TheRecordedCommandRepeatsTheRender) {
  const Sandbox sandbox;
  sandbox.orbs(run_of("exit3"));
  const auto job = results::read_job_file(sandbox.folder() / "out/exit3/grey/job.json").job;
  const auto answer = sandbox.shell("cd out && " + job.program.shell);
  EXPECT_EQ(answer.status, 3) << job.program.shell << "\n" << answer.text;
  EXPECT_EQ(answer.text, "fake: cannot find the sun\n");
  EXPECT_NE(sandbox.read("out/results.csv").find("--mode exit3"), std::string::npos);
  EXPECT_NE(sandbox.read("out/junit.xml").find("--mode exit3"), std::string::npos);
}

TEST(Faults, ASceneOutsideTheSuiteIsRefused) {
  const Sandbox sandbox;
  auto text = sandbox.read("cases/m1_grey/case.json");
  text.replace(text.find("grey.json"), 9, "../../elsewhere.json");
  sandbox.write("cases/m1_grey/case.json", text);
  sandbox.write("elsewhere.json", sandbox.read("cases/m1_grey/grey.json"));
  const auto answer = sandbox.orbs(run_of("good"));
  EXPECT_EQ(answer.status, 2);
  EXPECT_NE(answer.text.find("lies outside the suite's cases"), std::string::npos) << answer.text;
  EXPECT_FALSE(sandbox.has("out"));
}
