// Two studies of cost, of which one is the other with a factor in its times.
#include "base/error.h"
#include "studies/cost/change.h"
#include "studies/cost/change_text.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

using namespace orbs;
using namespace orbs::studies;

namespace {

struct Made {
  double factor = 1;          // of the times of "tracer"
  double machine = 1;         // of all times
  std::string version = "1";  // of "tracer"
  unsigned seed = 1;
};

// "tracer" and "other" on 20 scenes, whose errors fall with the time; times scatter by 1 %.
CostRecord study(const Made& made) {
  std::mt19937 random(made.seed);
  std::normal_distribution<double> normal;
  CostRecord record;
  record.is_finished = true;
  record.suite = "s";
  record.size = "1/4";
  record.host.cpu = "cpu";
  record.settings.target_db = 35;
  record.renderers = {{"tracer", made.version, SweepOf::Samples, ""}, {"other", "7", SweepOf::Samples, ""}};
  for (std::size_t t = 0; t < 20; ++t) {
    record.targets.push_back({"t" + std::to_string(t), "M1", "", 8, 8, "", {}});
    for (std::size_t r = 0; r < 2; ++r) {
      record.sweeps.push_back({t, r, {}, "", ""});
      const auto add = [&](Purpose purpose, int spp) {
        for (int seed = 0; seed < 4; ++seed) {
          CostRender one{.target = t, .renderer = r, .purpose = purpose, .spp = spp, .seed = seed};
          one.setting = std::to_string(spp) + " spp";
          one.cpu_seconds = 0.01 * spp * made.machine * (r == 0 ? made.factor : 1) *
                            std::exp(0.01 * normal(random)) * (1 + 0.1 * static_cast<double>(t));
          one.mse = one.relmse = 0.1 / spp * std::exp(0.02 * normal(random));
          one.psnr_srgb8 = 10 * std::log10(spp * 200.0) + 0.05 * normal(random);
          record.renders.push_back(one);
        }
      };
      for (const int spp : {4, 8, 16, 32}) {
        record.sweeps.back().settings.push_back({std::to_string(spp) + " spp", spp});
        add(Purpose::Sweep, spp);
      }
      if (r == 0) add(Purpose::Again, 16);
    }
  }
  return record;
}

const MeanChange& mean_of(const CostChanges& changes, const std::string& renderer) {
  for (const auto& one : changes.means)
    if (one.renderer == renderer && one.error == changes.main_error) return one;
  throw InputError("no mean of " + renderer);
}

}  // namespace

TEST(CostChange, FindsTheFactorOfTheProgramThatChangedAndNoneOfTheOther) {
  const auto changes = cost_changes(study({}), study({.factor = 1.1, .version = "2", .seed = 2}));
  const auto& tracer = mean_of(changes, "tracer");
  EXPECT_TRUE(tracer.is_changed);
  EXPECT_EQ(tracer.scenes, 20);
  EXPECT_LT(tracer.time_ratio.low, 1.1);
  EXPECT_GT(tracer.time_ratio.high, 1.1);
  EXPECT_GT(tracer.time_ratio.low, 1.07);
  EXPECT_FALSE(mean_of(changes, "other").is_changed);
  EXPECT_EQ(exit_status(changes), 1);
  EXPECT_EQ(exit_status(cost_changes(study({.factor = 1.1}), study({.seed = 2}))), 0)
      << "faster is no failure";
}

// A slow machine makes every time longer: what is over the unchanged program stays.
TEST(CostChange, TheProgramThatDidNotChangeTellsWhatTheMachineDid) {
  const auto changes =
      cost_changes(study({}), study({.factor = 1.1, .machine = 1.3, .version = "2", .seed = 2}));
  const auto& tracer = mean_of(changes, "tracer");
  EXPECT_NEAR(tracer.time_ratio.value, 1.43, 0.03);
  ASSERT_TRUE(tracer.ratio_to_unchanged);
  EXPECT_NEAR(tracer.ratio_to_unchanged->value, 1.1, 0.02);
  EXPECT_TRUE(mean_of(changes, "other").is_changed);
  EXPECT_FALSE(mean_of(changes, "other").ratio_to_unchanged);
  EXPECT_NE(changes_text(changes, {}).find("the machine is another one than it was"), std::string::npos);
}

// kFalseChanges: 100 comparisons of equal programs call about one changed; more than six have a probability
// of 1 in 10,000.
TEST(CostChange, EqualProgramsAreSeldomCalledChanged) {
  int called = 0;
  for (unsigned seed = 0; seed < 100; ++seed) {
    const auto changes = cost_changes(study({.seed = 2 * seed}), study({.seed = 2 * seed + 1}));
    bool any = false;
    for (const auto& one : changes.means) any |= one.is_changed && one.error == changes.main_error;
    for (const auto& one : changes.scenes) any |= one.is_changed && one.error == changes.main_error;
    called += any ? 1 : 0;
  }
  EXPECT_LE(called, 6);
}

TEST(CostChange, RefusesWhatCannotBeComparedAndNamesWhatIsMissing) {
  auto other = study({});
  other.size = "1";
  EXPECT_THROW(cost_changes(study({}), other), InputError);
  other = study({});
  other.host.cpu = "another";
  EXPECT_THROW(cost_changes(study({}), other), InputError);
  other = study({});
  other.renderers[1].name = "third";
  other.targets[3].reference_noise.relmse = 1e-3;
  const auto changes = cost_changes(study({}), other);
  const auto text = changes_text(changes, {});
  EXPECT_NE(text.find("only the earlier study has the renderer other"), std::string::npos) << text;
  EXPECT_NE(text.find("only the later study has the renderer third"), std::string::npos) << text;
  EXPECT_NE(text.find("the reference of t3 is another one"), std::string::npos) << text;
  EXPECT_EQ(mean_of(changes, "tracer").scenes, 19);
}
