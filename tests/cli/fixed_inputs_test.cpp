// What a run is judged by is fixed when it starts, and --resume sees whatever has changed since.
#include "base/files.h"
#include "cli/sandbox.h"
#include "image/image_io.h"
#include "results/record.h"

#include <algorithm>
#include <fstream>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

using namespace orbs;
using cli_tests::Answer;
using cli_tests::contains;
using cli_tests::Sandbox;

namespace {

constexpr const char* kFake = ORBS_BINARY_WORD "/orbs-fake-renderer";

void write_program(const Sandbox& sandbox, const std::string& name, const std::string& text) {
  sandbox.write(name, text);
  ::chmod((sandbox.folder() / name).c_str(), 0755);
}

// A renderer that does something to the sandbox before each of its renders.
void write_renderer(const Sandbox& sandbox, const std::string& first) {
  write_program(sandbox, "render",
                fmt::format("#!/bin/sh\n[ \"$1\" = --version ] || {}\nexec {} \"$@\"\n", first, kFake));
}

void write_grey(const std::filesystem::path& file, float grey) {
  auto image = image::make_image(12, 8, {"R", "G", "B"});
  std::fill(image.pixels.begin(), image.pixels.end(), grey);
  image::write_exr(image, file);
}

Answer run_own(const Sandbox& sandbox) {
  return sandbox.orbs({"run", "-r", "good", "-e", "./render", "-s", "grey", "-o", "out"});
}

Answer resume(const Sandbox& sandbox) { return sandbox.orbs({"run", "--resume", "out"}); }

results::TargetRecord grey_target(const Sandbox& sandbox) {
  return results::read_job_file(sandbox.folder() / "out/good/grey/job.json").targets.at(0);
}

}  // namespace

TEST(FixedInputs, AReferenceThatIsReplacedDuringTheRunIsForTheNextOne) {
  const Sandbox sandbox;
  const auto reference = sandbox.folder() / "references/grey.exr";
  const auto old = sandbox.read("references/grey.exr");
  write_grey(sandbox.folder() / "other.exr", 0.2F);
  write_renderer(sandbox,
                 fmt::format("cp {} {}", (sandbox.folder() / "other.exr").string(), reference.string()));
  const auto first = run_own(sandbox);
  EXPECT_EQ(first.status, 0) << first.text;
  EXPECT_EQ(sandbox.read("out/references/grey.exr"), old);
  EXPECT_EQ(grey_target(sandbox).reference, reference.string());
  EXPECT_EQ(resume(sandbox).status, 1) << "the replaced reference was not seen";
  EXPECT_EQ(sandbox.read("out/references/grey.exr"), sandbox.read("other.exr"));
  write_file(reference, old);
  EXPECT_EQ(resume(sandbox).status, 0) << "the restored reference was not seen";
}

TEST(FixedInputs, ACopyOfAReferenceThatTheRendererChangesJudgesNothing) {
  const Sandbox sandbox;
  write_renderer(sandbox, fmt::format("cp {0}/references/mirror.exr {0}/out/references/grey.exr; echo >> "
                                      "{0}/out/references/grey.exr",
                                      sandbox.folder().string()));
  const auto answer = run_own(sandbox);
  EXPECT_EQ(answer.status, 1) << answer.text;
  EXPECT_EQ(grey_target(sandbox).verdict, results::Verdict::MissingReference);
  EXPECT_TRUE(contains(answer.text, "out/references/grey.exr: this copy has changed since the run started"))
      << answer.text;
}

// A difference is judged from files that lay open to every renderer since.
TEST(FixedInputs, AnImageThatALaterRenderDamagesSpoilsItsDifferenceAndNothingElse) {
  const Sandbox sandbox;
  sandbox.write("spoil.sh",
                "for image in ../../../../*/*/result.exr; do echo spoiled >\"$image\"; done\nexec \"$@\"\n");
  replace_in(sandbox, "configuration.json", R"("command": ["{executable}", "--mode", "good")",
             R"("command": ["sh", "{root}/spoil.sh", "{executable}", "--mode", "good")");
  const auto answer = sandbox.orbs({"run", "-r", "good", "-c", "m3_mirror", "-j", "1", "-o", "out"});
  EXPECT_EQ(answer.status, 1) << answer.text;
  EXPECT_TRUE(
      contains(answer.text, "its scene 'mirror': good/mirror/result.exr: has changed since its render"))
      << answer.text;
  EXPECT_TRUE(contains(sandbox.read("out/results.json"), "\"verdict\": \"unreadable\""));
}

TEST(FixedInputs, ARebuiltProgramRendersAgain) {
  const Sandbox sandbox;
  write_renderer(sandbox, "true");
  EXPECT_EQ(run_own(sandbox).status, 0);
  EXPECT_FALSE(contains(resume(sandbox).text, "good grey:")) << "nothing has changed yet";
  write_renderer(sandbox, "false");
  const auto answer = resume(sandbox);
  EXPECT_TRUE(contains(answer.text, "good grey: its program, or a file that its command names, has changed"))
      << answer.text;
  EXPECT_FALSE(contains(resume(sandbox).text, "good grey:")) << "rendered by the new program, and again";
}

TEST(FixedInputs, AProgramThatIsReplacedDuringTheRunIsSaidAndRendersAgain) {
  const Sandbox sandbox;
  write_renderer(sandbox, fmt::format("echo '#' >> {}", (sandbox.folder() / "render").string()));
  const auto first = run_own(sandbox);
  EXPECT_TRUE(contains(first.text,
                       "good grey: its program, or a file that its command names, has changed since "
                       "the run started"))
      << first.text;
  write_renderer(sandbox, "true");
  EXPECT_TRUE(contains(resume(sandbox).text, "good grey: its program")) << "it was rendered by either";
}

TEST(FixedInputs, AnEditedFileOfTheCommandRendersAgain) {
  const Sandbox sandbox;
  auto text = sandbox.read("configuration.json");
  const std::string mode = R"("--mode", "good")";
  text.insert(text.find(mode) + mode.size(), R"(, "--adapter", "{root}/adapter.py")");
  sandbox.write("configuration.json", text);
  sandbox.write("adapter.py", "first");
  sandbox.orbs({"run", "-r", "good,dark", "-s", "grey", "-o", "out"});
  sandbox.write("adapter.py", "again");
  const auto answer = resume(sandbox);
  EXPECT_TRUE(contains(answer.text, "good grey: its program, or a file that its command names, has changed"))
      << answer.text;
  EXPECT_FALSE(contains(answer.text, "dark grey:")) << answer.text;
}

TEST(FixedInputs, ACrashATimeoutAndAMissingImageAreTriedAgain) {
  const Sandbox sandbox;
  sandbox.orbs({"run", "-r", "segfault,hang,nothing,nan", "-s", "grey", "-o", "out"});
  const auto answer = resume(sandbox);
  for (const char* again : {"segfault grey: it ended without an image (crash) and is tried again",
                            "hang grey: it ended without an image (timeout)",
                            "nothing grey: it ended without an image (no output)"})
    EXPECT_TRUE(contains(answer.text, again)) << again << " in\n" << answer.text;
  EXPECT_FALSE(contains(answer.text, "nan grey: it ended")) << answer.text;
}

TEST(FixedInputs, AnEditedSceneFileOrImageInTheFolderOfTheRunIsNoticed) {
  const Sandbox sandbox;
  sandbox.orbs({"run", "-r", "good", "-s", "grey,v1.5", "-o", "out"});
  const auto scene = sandbox.read("out/good/grey/scene.json");
  sandbox.write("out/good/grey/scene.json", scene + " ");
  write_grey(sandbox.folder() / "out/good/v1.5/result.exr", 0.25F);
  const auto answer = resume(sandbox);
  for (const char* name : {"grey", "v1.5"})
    EXPECT_TRUE(contains(answer.text, fmt::format("good {}: its scene file or image in the folder of the run "
                                                  "has changed",
                                                  name)))
        << answer.text;
  EXPECT_EQ(sandbox.read("out/good/grey/scene.json"), scene);
  EXPECT_EQ(answer.status, 0) << answer.text;
}
