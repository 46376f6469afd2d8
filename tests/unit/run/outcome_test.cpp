#include "run/outcome.h"

#include "image/image_io.h"
#include "structure/source_files.h"

#include <chrono>
#include <csignal>
#include <filesystem>
#include <limits>

#include <gtest/gtest.h>

using orbs::adapters::ProcessResult;
using orbs::results::JobOutcome;
using orbs::run::classify;
using orbs::structure::TestFolder;
using orbs::supervisor::Cause;

namespace {

class OutcomeTest : public testing::Test {
 protected:
  OutcomeTest() : scratch_("runner-outcome") {
    scratch_.write("keep", "");
    job_.folder = scratch_.path();
    job_.image = scratch_.path() / "result.exr";
    job_.width_px = 4;
    job_.height_px = 3;
  }
  void write(int width, int height, const std::vector<std::string>& channels, float value = 0.5F) const {
    auto image = orbs::image::make_image(width, height, channels);
    image.pixels.back() = value;
    orbs::image::write_exr(image, job_.image);
  }
  orbs::run::Outcome outcome(const ProcessResult& process = {}) const {
    orbs::ProcessLimits limits;
    limits.wall_seconds = 9;
    limits.cpu_seconds = 4;
    limits.memory_bytes = 3 << 20;
    limits.output_bytes = 1 << 19;
    return classify(process, job_, limits);
  }

  TestFolder scratch_;
  orbs::adapters::Job job_;
};

}  // namespace

TEST_F(OutcomeTest, AGoodImageIsAPassAndIsThere) {
  write(4, 3, {"R", "G", "B"});
  const auto result = outcome();
  EXPECT_EQ(result.kind, JobOutcome::Image);
  ASSERT_TRUE(result.image);
  EXPECT_EQ(result.image->width, 4);
}

// Each later fault is there too, and each must be silent behind the earlier ones.
TEST_F(OutcomeTest, TheFirstFaultInTheFixedOrderIsTheAnswer) {
  ProcessResult process;
  process.exit_code = 3;
  EXPECT_EQ(outcome(process).reason, "ended with exit code 3");
  process.signal = SIGSEGV;
  EXPECT_EQ(outcome(process).reason, "was killed by SIGSEGV");
  EXPECT_EQ(outcome(process).kind, JobOutcome::Crash);
  process.cause = Cause::WallTime;
  EXPECT_EQ(outcome(process).kind, JobOutcome::Timeout);
  EXPECT_EQ(outcome(process).reason, "was ended after its time limit of 9 s");
  process.start_error = "Permission denied";
  EXPECT_EQ(outcome(process).reason, "could not start: Permission denied");
}

TEST_F(OutcomeTest, AGoodImageDoesNotExcuseABadEnd) {
  write(4, 3, {"R", "G", "B"});
  ProcessResult process;
  process.signal = SIGABRT;
  EXPECT_EQ(outcome(process).kind, JobOutcome::Crash);
}

// Its exit code is 0 and the image is there, without the mesh.
TEST_F(OutcomeTest, ALineThatItsEntryCallsAFailureIsOne) {
  write(4, 3, {"R", "G", "B"});
  ProcessResult process;
  process.output =
      "loading\nMesh not found at: " + (scratch_.path() / "a.vsgf").string() + "\n 10 %\r100 %\n";
  EXPECT_EQ(outcome(process).kind, JobOutcome::Image);
  job_.fails_on = {"^ERROR", "not found"};
  EXPECT_EQ(outcome(process).kind, JobOutcome::Crash);
  EXPECT_EQ(outcome(process).reason, "said that it failed: Mesh not found at: a.vsgf");
  process.exit_code = 3;
  EXPECT_TRUE(outcome(process).reason.starts_with("ended with exit code 3")) << outcome(process).reason;
}

TEST_F(OutcomeTest, NoImageIsNoOutput) {
  EXPECT_EQ(outcome().kind, JobOutcome::NoOutput);
  EXPECT_EQ(outcome().reason, "wrote no result.exr");
}

TEST_F(OutcomeTest, WhatCannotBeReadIsUnreadable) {
  scratch_.write("result.exr", "this is no image");
  EXPECT_EQ(outcome().kind, JobOutcome::Unreadable);
  scratch_.write("result.exr", "");
  EXPECT_EQ(outcome().kind, JobOutcome::Unreadable);
  EXPECT_EQ(outcome().reason, "result.exr is empty");
}

// The folder is another one when the run has ended.
TEST_F(OutcomeTest, FilesAreNamedWithinTheFolderOfTheRender) {
  scratch_.write("result.exr", "this is no image");
  EXPECT_TRUE(outcome().reason.starts_with("result.exr: ")) << outcome().reason;
  ProcessResult process;
  process.exit_code = 1;
  process.output = "cannot read " + (scratch_.path() / "scene.json").string();
  EXPECT_EQ(outcome(process).reason, "ended with exit code 1; its last words: cannot read scene.json");
}

TEST_F(OutcomeTest, ALostSupervisorIsNoRendererThatDidNotStart) {
  ProcessResult process;
  process.orphaned = "its supervisor was killed by SIGKILL";
  EXPECT_EQ(outcome(process).kind, JobOutcome::Crash);
  EXPECT_EQ(outcome(process).reason, "was lost: its supervisor was killed by SIGKILL");
}

TEST_F(OutcomeTest, ASupervisorThatDoesNotAnswerAnInterruptIsAnInterrupt) {
  ProcessResult process;
  process.orphaned = "its supervisor did not answer within 17 s after the interrupt of the run";
  process.cause = Cause::Stopped;
  EXPECT_EQ(outcome(process).kind, JobOutcome::Skipped);
}

TEST_F(OutcomeTest, ASignalOfTheFileSizeAloneIsACrash) {
  ProcessResult process;
  process.signal = SIGXFSZ;
  EXPECT_EQ(outcome(process).kind, JobOutcome::Crash);
  EXPECT_EQ(
      outcome(process).reason,
      "was killed by SIGXFSZ, which the kernel sends when a file outgrows 0.5 MB; its folder holds less");
}

TEST_F(OutcomeTest, WordsThatNoTerminalShouldTakeAreMarked) {
  ProcessResult process;
  process.exit_code = 1;
  process.output = std::string("10 %\r99 %\r\x1blamp \xfe of \u00b5m") + '\0' + "\u009b";
  EXPECT_EQ(outcome(process).reason,
            "ended with exit code 1; its last words: \uFFFDlamp \uFFFD of \u00b5m\uFFFD\uFFFD");
}

TEST_F(OutcomeTest, AnImageFromElsewhereIsNone) {
  write(4, 3, {"R", "G", "B"});
  std::filesystem::rename(job_.image, scratch_.path() / "other.exr");
  std::filesystem::create_symlink("other.exr", job_.image);
  EXPECT_EQ(outcome().kind, JobOutcome::NoOutput);
  EXPECT_EQ(outcome().reason, "result.exr is no file of its own but a symbolic link");
}

TEST_F(OutcomeTest, AnImageOlderThanItsRenderIsStale) {
  write(4, 3, {"R", "G", "B"});
  const auto written = std::filesystem::last_write_time(job_.image);
  job_.ready_since = written;
  EXPECT_EQ(outcome().kind, JobOutcome::Image);
  std::filesystem::last_write_time(job_.image, written - std::chrono::milliseconds(1));
  EXPECT_EQ(outcome().kind, JobOutcome::Stale);
}

// As if the clock had been stepped back while it was rendered: all its times are before the start.
TEST_F(OutcomeTest, AnImageThatCameBeforeItsRenderByTheClockIsNotStale) {
  write(4, 3, {"R", "G", "B"});
  job_.ready_since = std::filesystem::last_write_time(job_.image) + std::chrono::hours(1);
  EXPECT_EQ(outcome().kind, JobOutcome::Image) << outcome().reason;
}

TEST_F(OutcomeTest, AnImageThatSaysItIsOfSomethingElseIsStale) {
  job_.id = "a";
  job_.scene_file_hash = "b";
  auto image = orbs::image::make_image(4, 3, {"R", "G", "B"});
  orbs::image::write_exr(image, job_.image);
  EXPECT_EQ(outcome().kind, JobOutcome::Image);  // says nothing
  image.attributes = {{"orbs.job", "a"}, {"orbs.scene_hash", "b"}};
  orbs::image::write_exr(image, job_.image);
  EXPECT_EQ(outcome().kind, JobOutcome::Image);
  image.attributes["orbs.job"] = "c";
  orbs::image::write_exr(image, job_.image);
  EXPECT_EQ(outcome().kind, JobOutcome::Stale);
}

TEST_F(OutcomeTest, EachLimitHasItsOutcomeAndSaysItself) {
  ProcessResult process;
  process.signal = SIGKILL;
  process.cause = Cause::CpuTime;
  EXPECT_EQ(outcome(process).kind, JobOutcome::Timeout);
  EXPECT_EQ(outcome(process).reason, "was ended after 4 s of processor time, its limit");
  process.cause = Cause::Memory;
  EXPECT_EQ(outcome(process).kind, JobOutcome::OutOfMemory);
  EXPECT_EQ(outcome(process).reason, "was ended because it took more than its 3 MB of memory");
  process.cause = Cause::Output;
  EXPECT_EQ(outcome(process).kind, JobOutcome::Crash);
  EXPECT_EQ(outcome(process).reason, "was ended because it wrote more than its 0.5 MB of files");
  process.cause = Cause::Stopped;
  EXPECT_EQ(outcome(process).kind, JobOutcome::Skipped);
}

TEST_F(OutcomeTest, TheLastWordsAndTheCoreAreToldWithACrash) {
  ProcessResult process;
  process.signal = SIGABRT;
  process.core_dumped = true;
  process.output = "loading\nassertion failed: sun > 0\n\n";
  EXPECT_EQ(outcome(process).reason,
            "was killed by SIGABRT (core dumped); its last words: assertion failed: sun > 0");
}

// Mitsuba ends its red message with a line that holds nothing but the end of the colour.
TEST_F(OutcomeTest, ColoursOfATerminalAreNoWords) {
  ProcessResult process;
  process.exit_code = 1;
  process.output = "\x1b[1m\x1b[31mthere is no lamp\x1b[0m\n\x1b[0m\n";
  EXPECT_EQ(outcome(process).reason, "ended with exit code 1; its last words: there is no lamp");
}

TEST_F(OutcomeTest, ALineThatNamesAnErrorSaysMoreThanTheLast) {
  ProcessResult process;
  process.exit_code = 1;
  process.output =
      "warming up\nError: scene.pbrt:1:7: unknown option\nError: Fatal errors during scene construction\nbye\n";
  EXPECT_EQ(outcome(process).reason,
            "ended with exit code 1; its last words: Error: scene.pbrt:1:7: unknown option");
  process.output = "Traceback (most recent call last):\n  File \"a\", line 1\nValueError: no lamp\n";
  EXPECT_EQ(outcome(process).reason, "ended with exit code 1; its last words: ValueError: no lamp");
}

// pbrt's spectral film writes R, G and B too, which are something else.
TEST_F(OutcomeTest, TheColourIsInTheChannelsThatTheJobNames) {
  auto image = orbs::image::make_image(4, 3, {"R", "G", "B", "S0.1nm", "S0.2nm", "S0.3nm"});
  for (std::size_t i = 0; i < image.pixels.size(); ++i)
    image.pixels[i] = i % 6 < 3 ? -1 : static_cast<float>(i % 6);
  orbs::image::write_exr(image, job_.image);
  job_.channels = {"S0.3nm", "S0.2nm", "S0.1nm"};
  const auto found = outcome();
  ASSERT_EQ(found.kind, JobOutcome::Image) << found.reason;
  EXPECT_EQ(found.image->channels, (std::vector<std::string>{"R", "G", "B"}));
  EXPECT_EQ(found.image->at(3, 2, 0), 5.0F);
  EXPECT_EQ(found.image->at(3, 2, 2), 3.0F);
  job_.channels[1] = "S0.4nm";
  EXPECT_EQ(outcome().kind, JobOutcome::WrongChannels);
  EXPECT_NE(outcome().reason.find("expected S0.3nm, S0.4nm, S0.1nm"), std::string::npos) << outcome().reason;
}

TEST_F(OutcomeTest, ChannelsGetOurNamesWhereTheEntrySaysSo) {
  auto image = orbs::image::make_image(4, 3, {"B", "beauty.G", "beauty.R", "z.V"});
  for (std::size_t i = 0; i < image.pixels.size(); ++i) image.pixels[i] = static_cast<float>(i % 4);
  orbs::image::write_exr(image, job_.image);
  EXPECT_EQ(outcome().kind, JobOutcome::WrongChannels);
  job_.channel_names = {
      {"R", "beauty.R"}, {"G", "beauty.G"}, {"B", "beauty.B"}, {"depth.Z", "z.V"}, {"uv.U", "uv.X"}};
  const auto found = outcome();
  ASSERT_EQ(found.kind, JobOutcome::Image) << found.reason;
  EXPECT_FALSE(found.is_as_written);
  const auto at = [&](const char* name) {
    return found.image->at(1, 1, static_cast<std::size_t>(orbs::image::channel_index(*found.image, name)));
  };
  EXPECT_EQ(at("R"), 2.0F);
  EXPECT_EQ(at("G"), 1.0F);
  EXPECT_EQ(at("B"), 0.0F);  // by our name already
  EXPECT_EQ(at("depth.Z"), 3.0F);
  EXPECT_LT(orbs::image::channel_index(*found.image, "uv.U"), 0);
}

TEST_F(OutcomeTest, NegativeValuesAreForJobsThatMayHaveThem) {
  write(4, 3, {"R", "G", "B"}, -1.0F);
  job_.may_be_negative = true;
  EXPECT_EQ(outcome().kind, JobOutcome::Image);
}

TEST_F(OutcomeTest, AnotherSizeIsAnOutcomeOfItsOwn) {
  write(4, 2, {"R", "G", "B"});
  EXPECT_EQ(outcome().kind, JobOutcome::WrongSize);
  EXPECT_EQ(outcome().reason, "result.exr is 4 x 2 pixels, expected 4 x 3");
}

// Two megabytes can stand for two gigabytes of pixels. A file that ends behind its header has no pixel:
// whoever tried to decode one would call it unreadable, as the second half of the test does.
TEST_F(OutcomeTest, AnotherSizeIsFoundInTheHeaderAndNoPixelIsDecoded) {
  constexpr std::size_t kHeader_bytes =
      1000;  // more than the header and its table of lines, less than the whole
  for (const auto& [width, expected] : {std::pair{400, JobOutcome::WrongSize}, {4, JobOutcome::Unreadable}}) {
    auto image = orbs::image::make_image(width, width == 4 ? 3 : 300, {"R", "G", "B"});
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
      image.pixels[i] = static_cast<float>(i % 1009) * 0.37F;  // hard to compress
    orbs::image::write_exr(image, job_.image);
    const auto whole = std::filesystem::file_size(job_.image);
    std::filesystem::resize_file(job_.image,
                                 width == 4 ? whole - 8 : std::min<std::uintmax_t>(kHeader_bytes, whole));
    EXPECT_EQ(outcome().kind, expected) << outcome().reason;
  }
}

TEST_F(OutcomeTest, MissingChannelsAreNamed) {
  write(4, 3, {"Y"});
  EXPECT_EQ(outcome().kind, JobOutcome::WrongChannels);
  EXPECT_EQ(outcome().reason, "result.exr has the channels Y, expected R, G, B");
}

TEST_F(OutcomeTest, BadNumbersAreCountedWithThePlaceOfTheFirst) {
  write(4, 3, {"R", "G", "B"}, std::numeric_limits<float>::quiet_NaN());
  EXPECT_EQ(outcome().kind, JobOutcome::InvalidPixels);
  EXPECT_EQ(outcome().reason,
            "1 pixels are NaN, 0 infinite, 0 negative; the first is (3, 2), channel B, value nan; all "
            "lie in [3,2,4,3]");
  write(4, 3, {"R", "G", "B"}, std::numeric_limits<float>::infinity());
  EXPECT_EQ(outcome().kind, JobOutcome::InvalidPixels);
  write(4, 3, {"R", "G", "B"}, -1.0F);
  EXPECT_EQ(outcome().kind, JobOutcome::InvalidPixels);
}
