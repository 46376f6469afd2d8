#include "registry/filters.h"

#include "base/error.h"

#include <gtest/gtest.h>

using orbs::registry::select_names;
using Names = std::vector<std::string>;

namespace {

const Names kNames{"101", "123-red", "123-blue", "248-full"};

std::string message_of(const std::string& list) {
  try {
    select_names(kNames, list, "scene");
  } catch (const orbs::InputError& e) {
    return e.what();
  }
  return "no error";
}

}  // namespace

TEST(Filters, TakeNamesAndPatternsSeparatedByCommasInTheOrderOfTheNames) {
  EXPECT_EQ(select_names(kNames, "248*, 101", "scene"), (Names{"101", "248-full"}));
  EXPECT_EQ(select_names(kNames, "123-?e*,*lue", "scene"), (Names{"123-red", "123-blue"}));
  EXPECT_EQ(select_names(kNames, "*", "scene"), kNames);
}

// A mistyped name must not run nothing and say that all is well.
TEST(Filters, EachPatternMustChooseSomethingAndTheNearestNameIsOffered) {
  EXPECT_EQ(message_of("101,123-rad"),
            "no scene matches '123-rad' (did you mean '123-red'?); 'orbs list scenes' shows what there is");
  EXPECT_EQ(message_of("x*"), "no scene matches 'x*'; 'orbs list scenes' shows what there is");
  EXPECT_EQ(message_of(" ,"), "no scene is chosen: ' ,' holds no name");
}
