#include "base/error.h"
#include "base/files.h"
#include "base/random.h"
#include "page/fixture_stability.h"
#include "results/study_kinds.h"
#include "studies/effects/paired_difference.h"
#include "studies/stability/images.h"
#include "studies/stability/json.h"
#include "studies/stability/numbers.h"
#include "studies/stability/report.h"
#include "unit/server/client.h"

#include <gtest/gtest.h>

using namespace orbs;
using namespace orbs::studies;

namespace {

// Grey 0.5 with uniform noise of its own for each seed, and a patch of 8 x 8 px that is brighter.
image::Image noisy_image(std::uint64_t seed, float noise, float patch = 0) {
  auto made = image::make_image(32, 32, {"R", "G", "B"});
  for (int y = 0; y < 32; ++y)
    for (int x = 0; x < 32; ++x)
      for (std::size_t c = 0; c < 3; ++c) {
        const auto bits = mix(seed, static_cast<std::uint64_t>((y * 32 + x) * 3) + c) >> 40;
        const bool is_patch = x >= 8 && x < 16 && y >= 16 && y < 24;
        made.at(x, y, c) =
            0.5F + noise * (static_cast<float>(bits) * 0x1p-24F - 0.5F) + (is_patch ? patch : 0);
      }
  return made;
}

std::vector<image::Image> pair_of(float noise, float patch = 0, std::uint64_t seed = 1) {
  return {noisy_image(seed, noise, patch), noisy_image(seed + 1, noise, patch)};
}

bool is_sure(const PairedDifference& found) {
  return found.mean.confidence >= kSure || found.largest.confidence >= kSure;
}

// A sweep of three scenes' steps by one renderer: scene 0 holds, scene 1 breaks at 1e3, scene 2 has nothing.
StabilityRecord made_up() {
  StabilityRecord record;
  record.is_finished = true;
  record.renderers = {{"r", "1.0"}};
  record.scenes = {{"a"}, {"b"}, {"c"}};
  record.relations = {{"scale_up", "the world enlarged", "", true, false},
                      {"threads", "three threads", "", false, true}};
  for (const double magnitude : {1e1, 1e2, 1e3, 1e4}) {
    record.steps.push_back({.scene = 0, .relation = 0, .magnitude = magnitude});
    StabilityStep step{.scene = 1, .relation = 0, .magnitude = magnitude};
    if (magnitude >= 1e3) {
      step.outcome = StepOutcome::Breaks;
      step.mean = -0.05;
      step.confidence = 1;
      step.reason = break_text(step);
    }
    record.steps.push_back(step);
  }
  record.steps.push_back({.scene = 2,
                          .relation = 0,
                          .magnitude = 10,
                          .outcome = StepOutcome::NotApplicable,
                          .reason = "it is empty"});
  record.steps.push_back({.scene = 0, .relation = 1, .is_bit_equal = true});
  return record;
}

}  // namespace

TEST(PairedDifference, OfTheSameImagesIsEqualToTheBit) {
  EXPECT_TRUE(paired_difference(pair_of(0.1F), pair_of(0.1F)).is_equal);
}

// With the same random numbers the noise drops out: one block of 16 is brighter by 0.1 of 0.5.
TEST(PairedDifference, FindsAPatchAndItsPlace) {
  const auto found = paired_difference(pair_of(0.1F), pair_of(0.1F, 0.1F));
  EXPECT_NEAR(found.largest.value, 0.2, 2e-3);
  EXPECT_GE(found.largest.confidence, kSure);
  EXPECT_EQ(found.x, 8);
  EXPECT_EQ(found.y, 16);
  EXPECT_NEAR(found.mean.value, 0.2 / 16, 2e-4);
}

// False alarms: 1 in 10,000 is allowed, so none of a hundred.
TEST(PairedDifference, TakesOtherNoiseForNoChange) {
  for (std::uint64_t seed = 10; seed < 210; seed += 2)
    EXPECT_FALSE(is_sure(paired_difference(pair_of(0.5F), pair_of(0.5F, 0, seed)))) << seed;
}

// The scatter of one pixel alone is known from two values only.
TEST(PairedDifference, TakesAnOutlierForNoEvidence) {
  auto changed = pair_of(0.1F);
  changed[0].at(3, 3, 1) = 1000;
  const auto found = paired_difference(pair_of(0.1F), changed);
  EXPECT_GT(found.mean.value, 0.3);
  EXPECT_FALSE(is_sure(found));
}

TEST(PairedDifference, OfARendererWithoutNoiseNeedsOnePair) {
  const auto found = paired_difference({noisy_image(1, 0)}, {noisy_image(1, 0, 1e-3F)});
  EXPECT_NEAR(found.largest.value, 2e-3, 1e-6);
  EXPECT_EQ(found.largest.confidence, 1);
}

TEST(PairedDifference, TurnsTheImageOfAChangedSceneBack) {
  auto original = image::make_image(2, 1, {"R", "G", "B"});
  original.pixels = {1, 2, 3, 4, 5, 6};
  auto changed = original;
  changed.pixels = {4, 5, 6, 1, 2, 3};
  EXPECT_EQ(original_of(changed, scene::MirroredImage{}).pixels, original.pixels);
  changed.pixels = {8, 16, 24, 32, 40, 48};
  EXPECT_EQ(original_of(changed, scene::MultipliedImage{8}).pixels, original.pixels);
  changed.pixels = {2, 3, 1, 5, 6, 4};
  EXPECT_EQ(original_of(changed, scene::RotatedChannels{}).pixels, original.pixels);
}

TEST(StabilityCells, CountTheDecadesOfTheWorstScene) {
  const auto cells = stability_cells(made_up());
  ASSERT_EQ(cells.size(), 2);
  EXPECT_EQ(cells[0].scenes, 2);
  EXPECT_EQ(cells[0].held_to, 100);
  EXPECT_EQ(cells[0].decades, 2);
  EXPECT_EQ(cells[0].first_break.value().magnitude, 1000);
  EXPECT_FALSE(cells[0].is_bit_equal);
  EXPECT_TRUE(cells[1].is_bit_equal);
}

// A sweep whose noise hides a step cannot count what comes after it.
TEST(StabilityCells, StopAtAStepThatIsInconclusive) {
  auto record = made_up();
  for (auto& step : record.steps)
    if (step.outcome == StepOutcome::Breaks) step.outcome = StepOutcome::Inconclusive;
  const auto cells = stability_cells(record);
  EXPECT_EQ(cells[0].held_to, 100);
  EXPECT_EQ(cells[0].inconclusive, 1);
  EXPECT_FALSE(cells[0].first_break.has_value());
}

TEST(StabilityReport, NamesTheFirstBreak) {
  const auto text = stability_markdown(made_up());
  for (const char* part :
       {"| the world enlarged | scale_up | to 100; breaks at 1000 (2 of 3) |",
        "| three threads | threads | holds, to the bit |", "the mean is off by -5 %",
        "r: 1 of 2 changes leave the image right. The world enlarged: right to 100; breaks at 1000 (b)."})
    EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
}

TEST(StabilityReport, TellsNotApplicableFromNotMeasured) {
  auto record = made_up();
  std::erase_if(record.steps, [](const auto& step) { return step.scene != 2; });
  const auto cells = stability_cells(record);
  EXPECT_EQ(cells[0].scenes, 0);
  EXPECT_EQ(cells[0].not_applicable, 1);
  EXPECT_EQ(cells[0].why_not_applicable, "it is empty");
  const auto text = stability_markdown(record);
  for (const char* part :
       {"| scale_up | not applicable |", "| threads | not measured |", "r: nothing was measured."})
    EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
}

TEST(StabilityReport, ShowsSeveralStudiesAsOne) {
  auto other = made_up();
  other.renderers.front().name = "s";
  const auto both = joined({made_up(), other});
  const auto text = stability_markdown(both);
  EXPECT_NE(text.find("| change | relation | r | s |"), std::string::npos) << text;
  EXPECT_EQ(stability_cells(both)[1].first_break.value().magnitude, 1000);
  EXPECT_THROW(joined({made_up(), made_up()}), InputError) << "the same renderer twice";
  other.settings.spp = 7;
  EXPECT_THROW(joined({made_up(), other}), InputError);
}

TEST(StabilityJson, IsReadBack) {
  const ScratchFolder scratch("stability");
  const auto file = scratch.path() / "stability.json";
  write_file(file, stability_json(made_up()));
  const auto read = read_stability_file(file);
  EXPECT_EQ(stability_json(read), stability_json(made_up()));
  EXPECT_FALSE(all_hold(read));
}

TEST(StabilityJson, RefusesAStepOfAnUnknownScene) {
  const ScratchFolder scratch("stability");
  const auto file = scratch.path() / "stability.json";
  auto record = made_up();
  record.steps[0].scene = 7;
  write_file(file, stability_json(record));
  EXPECT_THROW(read_stability_file(file), InputError);
}

TEST(StabilityFolder, NamesTheImagesOfBreaks) {
  const ScratchFolder scratch("stability");
  EXPECT_FALSE(results::study_kind_in(scratch.path()) != nullptr);
  page_tests::write_stability_study(scratch.path());
  ASSERT_TRUE(results::study_kind_in(scratch.path()) != nullptr);
  const auto study = results::read_study_folder(scratch.path());
  EXPECT_EQ(study.started, "2026-01-02T03:04:05");
  ASSERT_EQ(study.images.size(), 3);
  EXPECT_EQ(study.images[2], "breaks/cycles/block/translate_matrix-10000/difference.png");
}

TEST(ServerStudy, ServesAStudyOfStability) {
  const ScratchFolder scratch("stability");
  page_tests::write_stability_study(scratch.path());
  const server_tests::RunningServer server(scratch.path());
  EXPECT_NE(server.get("/data/runs.json").find(R"("kind": "stability")"), std::string::npos);
  EXPECT_EQ(server_tests::body_of(server.get("/data/0/file/stability.json")),
            read_file(scratch.path() / "stability.json"));
  EXPECT_EQ(server_tests::status_of(server.get("/data/0/overview.json")), 404);
}

TEST(StabilityRelations, AreChosenByPatterns) {
  EXPECT_EQ(stability_relations({"translate_*"}).size(), 2);
  EXPECT_EQ(stability_relations({}).size(), scene::relations().size() + 4);
  try {
    stability_relations({"scale_upp"});
    FAIL() << "there is no such relation";
  } catch (const InputError& e) {
    EXPECT_STREQ(
        e.what(),
        "there is no relation 'scale_upp' (did you mean 'scale_up'?); orbs stability --help lists them");
  }
}
