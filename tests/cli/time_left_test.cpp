#include "cli/run/time_left.h"

#include <gtest/gtest.h>

using orbs::cli::TimeLeft;

namespace {

const TimeLeft::Clock::time_point kStart{};

TimeLeft::Clock::time_point after(double seconds) {
  return kStart +
         std::chrono::duration_cast<TimeLeft::Clock::duration>(std::chrono::duration<double>(seconds));
}

}  // namespace

TEST(TimeLeft, FollowsWhatTheRendersOfARendererTake) {
  TimeLeft left;
  left.add("a1", "a", 10);
  left.add("a2", "a", 20);
  left.add("b1", "b", 100);
  EXPECT_NEAR(*left.seconds(kStart, 1), 130, 1e-9);
  EXPECT_NEAR(*left.seconds(kStart, 2), 65, 1e-9);
  left.started("a1", kStart);
  left.ended("a1", 30);
  // Three times as slow as expected, but for the doubt of a second; the other renderer is as it was.
  EXPECT_NEAR(*left.seconds(after(30), 1), 20 * 31.0 / 11 + 100, 1e-9);
}

TEST(TimeLeft, ARenderThatTakesLongerThanExpectedIsNotAboutToEnd) {
  TimeLeft left;
  left.add("a1", "a", 2);
  left.started("a1", kStart);
  EXPECT_NEAR(*left.seconds(after(1), 1), 1, 1e-9);
  EXPECT_NEAR(*left.seconds(after(20), 1), 5, 1e-9);
  left.ended("a1", 24);
  EXPECT_TRUE(left.is_over());
}

TEST(TimeLeft, WithoutAnEstimateIsThatOfTheOthersOfItsRenderer) {
  TimeLeft left;
  left.add("a1", "a", std::nullopt);
  left.add("a2", "a", std::nullopt);
  EXPECT_FALSE(left.seconds(kStart, 1));
  left.ended("a1", 7);
  EXPECT_NEAR(*left.seconds(kStart, 1), 7, 1e-9);
}
