#include "base/error.h"
#include "results/prices.h"
#include "structure/source_files.h"

#include <gtest/gtest.h>

using namespace orbs;

namespace {

constexpr const char* kTwoScenes = R"({"format": "orbs-prices/1", "scenes": [
  {"scene": "a", "alternatives": [
    {"name": "polarised", "time_ratio": {"median": 1.5}, "error_ratio": 1.25, "target": "same to the bit"},
    {"name": "rgb", "time_ratio": {"median": 0.5}, "error_ratio": 0, "target": "mean -8 %"}]},
  {"scene": "b", "alternatives": []}]})";

}  // namespace

TEST(Prices, AreFoundByScene) {
  const structure::TestFolder scratch("results-prices");
  scratch.write("prices.json", kTwoScenes);
  const auto prices = results::read_prices(scratch.path() / "prices.json");
  ASSERT_EQ(prices.size(), 1U);
  ASSERT_EQ(prices.at("a").size(), 2U);
  EXPECT_EQ(prices.at("a")[0].name, "polarised");
  EXPECT_EQ(prices.at("a")[0].time_ratio, 1.5);
  EXPECT_EQ(prices.at("a")[0].error_ratio, 1.25);
  EXPECT_EQ(prices.at("a")[1].target, "mean -8 %");
}

TEST(Prices, NobodyNeedsToHaveAsked) { EXPECT_TRUE(results::read_prices("/no/such/prices.json").empty()); }

TEST(Prices, AnotherFileSaysWhatItShouldBe) {
  const structure::TestFolder scratch("results-prices");
  scratch.write("prices.json", R"({"format": "orbs-run/1"})");
  EXPECT_THROW(results::read_prices(scratch.path() / "prices.json"), InputError);
}
