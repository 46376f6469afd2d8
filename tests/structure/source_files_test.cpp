#include "structure/source_files.h"

#include <gtest/gtest.h>

TEST(SourceFiles, BuildsAndHiddenFoldersAreNotSearched) {
  const orbs::structure::TestFolder scratch("source-files");
  for (const char* file : {"src/a.h", "build/release/b.h", ".git/c.h", "outputs-1/d.h", "src/image.png"})
    scratch.write(file, "x\n");
  const auto files = orbs::structure::files_below(scratch.path(), {".h"});
  ASSERT_EQ(files.size(), 1u);
  EXPECT_EQ(files.front(), scratch.path() / "src/a.h");
}
