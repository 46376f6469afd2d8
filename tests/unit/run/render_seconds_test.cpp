#include "run/plan/render_seconds.h"

#include "structure/source_files.h"

#include <gtest/gtest.h>

using orbs::registry::RenderSeconds;
using orbs::run::render_seconds;
using orbs::structure::TestFolder;

namespace {

std::optional<double> in_output(const std::string& pattern, const std::string& output) {
  return render_seconds({.pattern = pattern}, output, "/");
}

}  // namespace

TEST(RenderSeconds, AreTheNumberOfTheLastMatch) {
  EXPECT_EQ(in_output("^t: ([0-9.]+)", "a\nt: 1.5\nt: 2.25 s\nx t: 9\n"), 2.25);
  EXPECT_EQ(in_output("^t: ([0-9.]+)", "t: soon\n"), std::nullopt);
  EXPECT_EQ(in_output("^t: (.*)", "t: soon\n"), std::nullopt);
  EXPECT_EQ(in_output("", "t: 1\n"), std::nullopt);
}

TEST(RenderSeconds, ThatNoRenderCanTakeAreNone) {
  EXPECT_EQ(in_output("^t: (.*)", "t: -5\n"), std::nullopt);
  EXPECT_EQ(in_output("^t: (.*)", "t: 1e308\n"), std::nullopt);
  EXPECT_EQ(in_output("^t: (.*)", "t: inf\n"), std::nullopt);
  EXPECT_EQ(in_output("^t: (.*)", "t: nan\n"), std::nullopt);
  EXPECT_EQ(in_output("^t: (.*)", "t: 0\n"), 0);
}

TEST(RenderSeconds, AreReadBehindANul) {
  using namespace std::string_literals;
  EXPECT_EQ(in_output("^t: ([0-9.]+)", "noise \0 more\nt: 2.5\n"s), 2.5);
}

TEST(RenderSeconds, MayBeMinutesAndHoursToo) {
  EXPECT_EQ(in_output("Time: ([0-9]+):([0-9.]+)", "Time: 02:03.50 (Saving)\n"), 123.5);
  EXPECT_EQ(
      in_output("([0-9]+) hours +([0-9]+) minutes +([0-9]+) seconds", "1 hours  1 minutes  1 seconds\n"),
      3661);
}

// As Mitsuba's and pbrt's last lines say them.
TEST(RenderSeconds, MayHaveAUnit) {
  const std::string mitsuba = "took ([0-9.]+)(ms|s|m|h)";
  EXPECT_EQ(in_output(mitsuba, "Rendering finished. (took 850ms)\n"), 0.85);
  EXPECT_EQ(in_output(mitsuba, "Rendering finished. (took 34.998s)\n"), 34.998);
  EXPECT_EQ(in_output(mitsuba, "Rendering finished. (took 1.5m)\n"), 90);
  EXPECT_EQ(in_output(mitsuba, "Rendering finished. (took 2h)\n"), 7200);
  EXPECT_EQ(in_output("([0-9]+) (h) ([0-9]+) (min)", "1 h 30 min\n"), 5400);
  EXPECT_EQ(in_output("took ([0-9.]+)(s|fortnights)", "took 1fortnights\n"), std::nullopt);
}

TEST(RenderSeconds, MayBeInAFileAndInAnotherUnit) {
  const TestFolder folder("render-seconds");
  const RenderSeconds place{.file = "stats/times.json", .key = "render/wall", .unit_seconds = 0.001};
  EXPECT_EQ(render_seconds(place, "", folder.path()), std::nullopt);
  folder.write("stats/times.json", R"({"render": {"wall": 1500}})");
  EXPECT_EQ(render_seconds(place, "", folder.path()), 1.5);
  for (const char* text : {R"({"render": 3})", R"({"render": {"wall": "long"}})", "[1]", "{ torn"}) {
    folder.write("stats/times.json", text);
    EXPECT_EQ(render_seconds(place, "", folder.path()), std::nullopt) << text;
  }
}

TEST(RenderSeconds, AreNotReadThroughALink) {
  const TestFolder folder("render-seconds-link");
  folder.write("elsewhere/times.json", R"({"t": 1})");
  folder.write("job/keep", "");
  std::filesystem::create_symlink("../elsewhere/times.json", folder.path() / "job/times.json");
  EXPECT_EQ(render_seconds({.file = "times.json", .key = "t"}, "", folder.path() / "job"), std::nullopt);
}
