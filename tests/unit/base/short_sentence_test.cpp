#include "base/short_sentence.h"

#include "base/text_table.h"

#include <gtest/gtest.h>

using orbs::short_sentence;

TEST(ShortSentence, EndsWithAPhraseAndNotInsideANumber) {
  const std::string text = "the mean over the block is off by 1.74 % or more for certain";
  EXPECT_EQ(short_sentence(text, 100), text);
  EXPECT_EQ(short_sentence(text, 42), "the mean over the block is off ...");
  EXPECT_EQ(short_sentence(text, 48), "the mean over the block is off by 1.74 % ...");
  EXPECT_EQ(short_sentence("the left wall is 4 % too dark, at most 1.2 % is allowed", 50),
            "the left wall is 4 % too dark ...");
}

TEST(ShortSentence, FitsIntoEveryWidth) {
  const std::string text = "psnr is 34.43 dB, at least 35 is needed, without noise above 42.5 dB; more (x)";
  for (std::size_t most = 20; most < 90; ++most)
    EXPECT_LE(orbs::display_width(short_sentence(text, most)), most) << short_sentence(text, most);
}
