#include "image/image_io.h"
#include "runner/outcome.h"
#include "structure/source_files.h"

#include <csignal>
#include <limits>

#include <gtest/gtest.h>

using orbs::adapters::ProcessResult;
using orbs::results::Verdict;
using orbs::runner::classify;
using orbs::structure::TestFolder;

namespace {

class OutcomeTest : public testing::Test {
 protected:
  OutcomeTest() : scratch_("runner-outcome") {
    scratch_.write("keep", "");
    job_.image = scratch_.path() / "result.exr";
    job_.width_px = 4;
    job_.height_px = 3;
  }
  void write(int width, int height, const std::vector<std::string>& channels, float value = 0.5F) const {
    auto picture = orbs::image::make_image(width, height, channels);
    picture.pixels.back() = value;
    orbs::image::write_exr(picture, job_.image);
  }
  orbs::runner::Outcome outcome(const ProcessResult& process = {}) const {
    return classify(process, job_, 9);
  }

  TestFolder scratch_;
  orbs::adapters::Job job_;
};

}  // namespace

TEST_F(OutcomeTest, AGoodPictureIsAPassAndIsThere) {
  write(4, 3, {"R", "G", "B"});
  const auto result = outcome();
  EXPECT_EQ(result.verdict, Verdict::Pass);
  ASSERT_TRUE(result.picture);
  EXPECT_EQ(result.picture->width, 4);
}

// Each later fault is there too, and each must be silent behind the earlier ones.
TEST_F(OutcomeTest, TheFirstFaultInTheFixedOrderIsTheAnswer) {
  ProcessResult process;
  process.exit_code = 3;
  EXPECT_EQ(outcome(process).sentence, "ended with exit code 3");
  process.signal = SIGSEGV;
  EXPECT_EQ(outcome(process).sentence, "was killed by SIGSEGV");
  EXPECT_EQ(outcome(process).verdict, Verdict::Crash);
  process.timed_out = true;
  EXPECT_EQ(outcome(process).verdict, Verdict::Timeout);
  EXPECT_EQ(outcome(process).sentence, "was ended after its time limit of 9 s");
  process.start_error = "Permission denied";
  EXPECT_EQ(outcome(process).sentence, "could not start: Permission denied");
}

TEST_F(OutcomeTest, AGoodPictureDoesNotExcuseABadEnd) {
  write(4, 3, {"R", "G", "B"});
  ProcessResult process;
  process.signal = SIGABRT;
  EXPECT_EQ(outcome(process).verdict, Verdict::Crash);
}

TEST_F(OutcomeTest, NoPictureIsNoOutput) {
  EXPECT_EQ(outcome().verdict, Verdict::NoOutput);
  EXPECT_EQ(outcome().sentence, "wrote no result.exr");
}

TEST_F(OutcomeTest, AnUnreadablePictureIsNoOutput) {
  scratch_.write("result.exr", "this is no picture");
  EXPECT_EQ(outcome().verdict, Verdict::NoOutput);
}

TEST_F(OutcomeTest, AnotherSizeIsAVerdictOfItsOwn) {
  write(4, 2, {"R", "G", "B"});
  EXPECT_EQ(outcome().verdict, Verdict::WrongSize);
  EXPECT_EQ(outcome().sentence, "result.exr is 4 x 2 pixels, expected 4 x 3");
}

TEST_F(OutcomeTest, MissingChannelsAreNamed) {
  write(4, 3, {"Y"});
  EXPECT_EQ(outcome().verdict, Verdict::WrongSize);
  EXPECT_EQ(outcome().sentence, "result.exr has the channels Y, expected R, G, B");
}

TEST_F(OutcomeTest, BadNumbersAreCountedWithThePlaceOfTheFirst) {
  write(4, 3, {"R", "G", "B"}, std::numeric_limits<float>::quiet_NaN());
  EXPECT_EQ(outcome().verdict, Verdict::InvalidPixels);
  EXPECT_EQ(outcome().sentence,
            "1 pixels are NaN, 0 infinite, 0 negative; the first is (3, 2), channel B, value nan");
  write(4, 3, {"R", "G", "B"}, std::numeric_limits<float>::infinity());
  EXPECT_EQ(outcome().verdict, Verdict::InvalidPixels);
  write(4, 3, {"R", "G", "B"}, -1.0F);
  EXPECT_EQ(outcome().verdict, Verdict::InvalidPixels);
}
