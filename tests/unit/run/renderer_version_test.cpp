// What a version command prints, and which part of it is the version.
#include "run/renderer_version.h"

#include "base/files.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace {

using namespace orbs;

std::string version_in(const std::string& output, const std::string& pattern) {
  run::ChosenRenderer renderer;
  renderer.executable = "/usr/bin/printf";
  renderer.entry.command.version_command = {"{executable}", output};
  renderer.entry.command.version_pattern = pattern;
  return run::renderer_version(renderer, {});
}

}  // namespace

// Threads and vector width are the machine's: on another one all images would be outdated.
TEST(RendererVersion, IsTheGroupOfThePatternInTheFirstLineThatMatches) {
  const std::string output =
      "warming up\\nMitsuba version 3.8.0 ([], Linux, 64bit, 2 threads, 16-wide SIMD)\\nMitsuba version 9\\n";
  EXPECT_EQ(version_in(output, "^(Mitsuba version [^ ]+)"), "Mitsuba version 3.8.0");
  EXPECT_EQ(version_in(output, ""), "warming up");
}

TEST(RendererVersion, IsUnknownWhereNoLineMatches) {
  EXPECT_EQ(version_in("hello\\n", "^(pbrt version.*)"),
            "unknown: its version command prints no line that matches '^(pbrt version.*)'");
  EXPECT_EQ(version_in("", "^(pbrt version.*)"),
            "unknown: its version command prints no line that matches '^(pbrt version.*)'");
  EXPECT_EQ(version_in("\\n", ""), "unknown: its version command prints nothing");
}

// Blender takes more than five seconds where its files have to be read from the disk, and a run that lasts
// hours then has no version.
TEST(RendererVersion, IsAskedForOnceMoreWhereNoAnswerCame) {
  const ScratchFolder folder("orbs-version");
  run::ChosenRenderer renderer;
  renderer.executable = "/bin/sh";
  renderer.entry.name = "mine";
  renderer.entry.command.version_command = {
      "{executable}", "-c", R"(mkdir "$0" 2>/dev/null && exec tail -f /dev/null; echo version 7)",
      (folder.path() / "asked").string()};
  std::vector<std::string> said;
  const auto version = run::renderer_version(
      renderer, {},
      {.first_seconds = 2, .second_seconds = 60, .say = [&](const auto& line) { said.push_back(line); }});
  EXPECT_EQ(version, "version 7");
  EXPECT_EQ(said, std::vector<std::string>{
                      "mine: '/bin/sh' did not say its version within 2 s; waiting for up to 60 s"});
}

// A node that Slurm stops kills it: the run that is resumed, and the others that it is merged with, would be
// of another version than itself.
TEST(RendererVersion, IsNoTextOfAQueryThatWasKilled) {
  run::ChosenRenderer renderer;
  renderer.executable = "/bin/sh";
  renderer.entry.name = "mine";
  for (const char* pattern : {"", "(version .)"}) {
    renderer.entry.command.version_command = {"{executable}", "-c", "echo version 7; kill -9 $$"};
    renderer.entry.command.version_pattern = pattern;
    std::vector<std::string> said;
    const run::VersionRequest request{
        .first_seconds = 0.2, .second_seconds = 0.3, .say = [&](const auto& line) { said.push_back(line); }};
    EXPECT_EQ(run::renderer_version(renderer, {}, request), "");
    EXPECT_EQ(said,
              std::vector<std::string>{"mine: its version is not known: '/bin/sh' was killed by SIGKILL"});
    renderer.entry.command.version_command = {"{executable}", "-c", "echo version 7; exec tail -f /dev/null"};
    EXPECT_EQ(run::renderer_version(renderer, {}, request), "");
    EXPECT_EQ(said.back(), "mine: its version is not known: '/bin/sh' did not end within 0.3 s");
  }
}

TEST(RendererVersion, DiffersFromAnotherKnownOneAlone) {
  EXPECT_TRUE(run::is_other_version("1", "2"));
  EXPECT_FALSE(run::is_other_version("1", "1"));
  EXPECT_FALSE(run::is_other_version("1", ""));
  EXPECT_FALSE(run::is_other_version("unknown: 'x' ended with exit code 1", "2"));
}
