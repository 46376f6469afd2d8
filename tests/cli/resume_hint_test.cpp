// What an interrupted study says about how to go on.
#include "cli/run/resume_hint.h"

#include "cli/program.h"

#include <filesystem>

#include <gtest/gtest.h>

using namespace orbs::cli;

TEST(ResumeHint, KeepsAllOptionsButTheFolder) {
  const std::vector<std::string> first{"/bin/orbs", "cost", "-s", "101, 110", "-o", "c", "--time", "20m"};
  EXPECT_EQ(next_line(first, "c", false, "shows"),
            "next: /bin/orbs cost -s '101, 110' --time 20m --resume c   (continues this study)\n");
  const std::vector<std::string> again{"orbs", "stability", "--resume=old", "--seeds", "4"};
  EXPECT_EQ(resume_command(again, "s"),
            (std::vector<std::string>{"orbs", "stability", "--seeds", "4", "--resume", "s"}));
  EXPECT_EQ(next_line(again, "s", true, "shows the breaks"), "next: orbs serve s   (shows the breaks)\n");
}

TEST(CalledAs, IsWhatCanBePasted) {
  const auto here = std::filesystem::current_path();
  EXPECT_EQ(called_as({"orbs", "run"}), "orbs");
  EXPECT_EQ(called_as({(here / "build/release/orbs").string()}), "build/release/orbs");
  EXPECT_EQ(called_as({"./build/../orbs"}), "./orbs");
  EXPECT_EQ(called_as({(here.parent_path() / "orbs").string()}), (here.parent_path() / "orbs").string());
  EXPECT_EQ(called_as({}), "orbs");
}
