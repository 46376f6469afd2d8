// What studies print on a terminal: within its width, with whole numbers, and in colour where it has colours.
#include "base/text.h"
#include "base/text_table.h"
#include "page/fixture_cost.h"
#include "page/fixture_stability.h"
#include "structure/source_files.h"
#include "studies/cost/json.h"
#include "studies/cost/report.h"
#include "studies/stability/json.h"
#include "studies/stability/report.h"

#include <algorithm>
#include <set>

#include <gtest/gtest.h>

using namespace orbs;

namespace {

std::size_t widest(const std::string& text) {
  std::size_t widest = 0;
  for (const auto& line : split(text, '\n')) widest = std::max(widest, display_width(line));
  return widest;
}

std::set<std::string> numbers_of(const std::string& text) {
  std::set<std::string> numbers;
  for (const auto& word : words_of(text))
    if (word.find_first_of("0123456789") != std::string::npos) numbers.insert(word);
  return numbers;
}

bool has_only_numbers_of(const std::string& wide, const std::string& text) {
  const auto all = numbers_of(wide);
  const auto some = numbers_of(text);
  return std::includes(all.begin(), all.end(), some.begin(), some.end());
}

std::string without_colours(std::string text) {
  for (auto at = text.find('\x1b'); at != std::string::npos; at = text.find('\x1b'))
    text.erase(at, text.find('m', at) + 1 - at);
  return text;
}

studies::CostRecord made_up_cost() {
  const structure::TestFolder scratch("terminal-cost");
  page_tests::write_cost_study(scratch.path());
  return studies::read_cost_file(scratch.path() / "cost.json");
}

studies::StabilityRecord made_up_stability() {
  const structure::TestFolder scratch("terminal-stability");
  page_tests::write_stability_study(scratch.path());
  return studies::read_stability_file(scratch.path() / "stability.json");
}

}  // namespace

TEST(CostText, StaysWithinTheTerminalWithWholeNumbersAndNoColourUnlessAsked) {
  const auto record = made_up_cost();
  const auto wide = studies::cost_table(record, {});
  EXPECT_GT(widest(wide), 80U);
  EXPECT_EQ(wide.find('\x1b'), std::string::npos);
  for (const int width : {60, 80, 100}) {
    const auto text = studies::cost_table(record, {false, width});
    EXPECT_LE(widest(text), static_cast<std::size_t>(width)) << text;
    EXPECT_TRUE(has_only_numbers_of(wide, text)) << text;
  }
}

TEST(CostText, TheFastestIsGreenAndColoursTakeNoRoom) {
  const auto record = made_up_cost();
  const auto text = studies::cost_table(record, {true, 80});
  EXPECT_NE(text.find("\x1b[32m0.37 (0.34-0.4)"), std::string::npos) << text;
  EXPECT_LE(widest(text), 80U);
  const auto plain = without_colours(text);
  EXPECT_EQ(numbers_of(plain), numbers_of(studies::cost_table(record, {false, 80})));
}

TEST(StabilityText, StaysWithinTheTerminalWithWholeNumbersAndNoColourUnlessAsked) {
  const auto record = made_up_stability();
  const auto wide = studies::stability_table(record, {});
  EXPECT_GT(widest(wide), 80U);
  EXPECT_EQ(wide.find('\x1b'), std::string::npos);
  for (const int width : {60, 80, 100}) {
    const auto text = studies::stability_table(record, {false, width});
    EXPECT_LE(widest(text), static_cast<std::size_t>(width)) << text;
    EXPECT_TRUE(has_only_numbers_of(wide, text)) << text;
  }
}

TEST(StabilityText, BreaksAreRedAndWhatHoldsIsGreen) {
  const auto text = studies::stability_table(made_up_stability(), {true, 80});
  EXPECT_NE(text.find("\x1b[31mto 1000"), std::string::npos) << text;
  EXPECT_NE(text.find("\x1b[32mall, to 1e+09"), std::string::npos) << text;
  EXPECT_EQ(without_colours(text), studies::stability_table(made_up_stability(), {false, 80}));
}
