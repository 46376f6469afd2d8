#include "server/served.h"

#include <gtest/gtest.h>

namespace {

using Names = std::vector<std::string>;

TEST(RunNames, AreThoseOfTheFolders) {
  EXPECT_EQ(orbs::server::run_names({"/runs/outputs-2", "/runs/outputs-1"}),
            (Names{"outputs-2", "outputs-1"}));
}

TEST(RunNames, HoldOfTheFoldersAboveWhatTellsThemApart) {
  EXPECT_EQ(orbs::server::run_names({"/a/x/outputs", "/b/x/outputs", "/b/y/outputs", "/b/new"}),
            (Names{"a/x/outputs", "b/x/outputs", "y/outputs", "new"}));
  EXPECT_EQ(orbs::server::run_names({"/outputs", "/a/outputs"}), (Names{"/outputs", "a/outputs"}));
}

TEST(RunNames, TheSameFolderTwiceIsOneName) {
  EXPECT_EQ(orbs::server::run_names({"/a/outputs", "/a/outputs"}), (Names{"outputs", "outputs"}));
}

}  // namespace
