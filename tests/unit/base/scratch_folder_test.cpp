#include "base/files.h"

#include <gtest/gtest.h>

using namespace orbs;

TEST(ScratchFolder, TwoOfOneNameDoNotShareTheirFiles) {
  const ScratchFolder outer("orbs-test");
  write_file(outer.path() / "kept", "1");
  std::filesystem::path gone;
  {
    const ScratchFolder inner("orbs-test");
    gone = inner.path();
    EXPECT_TRUE(std::filesystem::is_directory(gone));
  }
  EXPECT_FALSE(std::filesystem::exists(gone));
  EXPECT_TRUE(std::filesystem::exists(outer.path() / "kept"));
}
