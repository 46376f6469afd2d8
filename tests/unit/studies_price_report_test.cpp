#include "json/object_reader.h"
#include "studies/price_list.h"

#include <gtest/gtest.h>

namespace {

using namespace orbs;

studies::PriceList list_of(const studies::Alternative& way) {
  studies::PriceList list;
  list.scenes = {{"prism", "spectral", {"dispersion"}, 1.25e6, {way}}};
  return list;
}

studies::Alternative way(bool is_enough, const std::string& bias) {
  return {"other", is_enough, {1.5, 1.4, 1.6}, 2, {false, {-0.01, 0.0002}, {3.18, 1.03}, 40, 8, bias}};
}

bool says(const studies::PriceList& list, const std::string& text) {
  return studies::price_table(list).find(text) != std::string::npos;
}

}  // namespace

TEST(PriceReport, SaysWhatIsLostWithItsError) {
  const auto list = list_of(way(false, "the mean is darker"));
  EXPECT_TRUE(says(list, "prism: spectral, 1.25 million paths per CPU second; dispersion"));
  EXPECT_TRUE(says(list, "mean -1.000 ± 0.020 %, most +318 ± 103 % at (40, 8)"))
      << studies::price_table(list);
  EXPECT_TRUE(studies::all_agree(list));  // who leaves something out need not agree
}

TEST(PriceReport, ARicherTransportThatDiffersIsAnError) {
  const auto list = list_of(way(true, "the mean is darker"));
  EXPECT_TRUE(says(list, "DIFFERS: mean -1.000")) << studies::price_table(list);
  EXPECT_FALSE(studies::all_agree(list));
  EXPECT_TRUE(studies::all_agree(list_of(way(true, ""))));
}

TEST(PriceReport, CausticsWithoutLightPathsAreNoError) {
  auto without = way(true, "the mean is darker");
  without.change.is_comparable = false;
  EXPECT_TRUE(studies::all_agree(list_of(without)));
  EXPECT_TRUE(says(list_of(without), "not compared"));
  without.change.bias = "";  // a firefly or two, whose noise explains anything
  EXPECT_TRUE(says(list_of(without), "not compared"));
}

TEST(PriceReport, MarkdownAndJsonHoldTheSame) {
  const auto list = list_of(way(false, ""));
  EXPECT_NE(
      studies::price_markdown(list).find("| prism | spectral | other | 1.50 | 2.00 | same but for noise |"),
      std::string::npos)
      << studies::price_markdown(list);
  const auto document = json::parse("prices.json", studies::price_json(list));
  json::ObjectReader prices(document);
  auto scenes = prices.objects("scenes");
  auto ways = scenes.at(0).objects("alternatives");
  EXPECT_EQ(ways.at(0).text("image"), "same but for noise");
  EXPECT_EQ(ways.at(0).object("time_ratio").number("most"), 1.6);
}
