// What a version command prints, and which part of it is the version.
#include "runner/renderer_version.h"

#include <gtest/gtest.h>

namespace {

using namespace orbs;

std::string version_in(const std::string& output, const std::string& pattern) {
  runner::ChosenRenderer renderer;
  renderer.executable = "/usr/bin/printf";
  renderer.entry.version_command = {"{executable}", output};
  renderer.entry.version_pattern = pattern;
  return runner::renderer_version(renderer, {});
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
