#include "report/short_reason.h"

#include <gtest/gtest.h>

using orbs::report::line_reason;
using orbs::report::short_reason;
using namespace orbs::results;

TEST(ShortReason, IsTheFirstSentenceWithoutWhatStandsInParentheses) {
  EXPECT_EQ(short_reason("B is 41.5 % darker", 0), "B is 41.5 % darker");
  EXPECT_EQ(short_reason("B is darker (43 % to 40 %; measured), at most 0.7 % is allowed; G is darker", 0),
            "B is darker, at most 0.7 % is allowed ...");
  EXPECT_EQ(short_reason("no end (of it", 0), "no end (of it");
  EXPECT_EQ(short_reason("shifted by (0.5, -2) px (measured): then 60.2 dB", 0),
            "shifted by (0.5, -2) px: then 60.2 dB ...");
}

TEST(ShortReason, IsCutBetweenWords) {
  std::string words;
  for (int i = 0; i < 40; ++i) words += "seven77 ";
  const auto text = short_reason(words, 0);
  EXPECT_LE(text.size(), 104U);
  EXPECT_TRUE(text.ends_with("seven77 ...")) << text;
}

// A line of 400 characters hid which check was new.
TEST(ShortReason, OfANewFailureTheNewsStaysWhole) {
  const std::string news =
      "it fails by window_error_16px, which is not among the failed checks of c.json:246";
  const std::string reasons = "R is darker (0.8 to 1 %), at most 0.7 % is allowed; G is darker";
  EXPECT_EQ(line_reason(Verdict::Fail, Expectation::News, news + "; " + reasons, 0),
            news + "; R is darker, at most 0.7 % is allowed ...");
  EXPECT_EQ(line_reason(Verdict::Fail, Expectation::News, news, 0), news);
  EXPECT_EQ(line_reason(Verdict::Crash, Expectation::None, reasons, 0), reasons);
}
