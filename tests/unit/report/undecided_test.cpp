#include "report/undecided.h"

#include <gtest/gtest.h>

using namespace orbs::report;

TEST(Undecided, AReasonSaysItsCauseAndWhatWouldDecideIt) {
  const auto noise =
      undecided_of("undecided: its noise: about 4 times the samples (12 s) would decide it; R is 1 %");
  ASSERT_TRUE(noise);
  EXPECT_EQ(noise->cause, "its noise");
  EXPECT_EQ(noise->times, 4);
  const auto edge = undecided_of("undecided: it lies on the edge of this gate; R is 1 % darker");
  ASSERT_TRUE(edge);
  EXPECT_EQ(edge->cause, "it lies on the edge of this gate");
  EXPECT_FALSE(edge->times);
  EXPECT_FALSE(undecided_of("R is 1 % darker"));
}

TEST(Undecided, SeveralAreCountedByWhatWouldDecideThem) {
  const auto needs = [](std::optional<double> times) { return Undecided{"its noise", times}; };
  EXPECT_EQ(undecided_text({needs(2), needs(3.5), needs(40), needs({})}),
            "4 undecided: its noise; 2 times the samples would decide 1 of them, 4 times 2, 64 times 3");
  EXPECT_EQ(undecided_text({needs({}), needs({})}), "2 undecided: its noise");
  EXPECT_EQ(undecided_text({needs(200), needs(900)}),
            "2 undecided: its noise; 200 times the samples would decide the first of them");
}
