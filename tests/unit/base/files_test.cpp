// What renderers leave behind, and orbs removes.
#include "base/files.h"

#include "structure/source_files.h"
#include "supervisor/folder_size.h"

#include <limits>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

namespace fs = std::filesystem;

namespace {

// Deeper than a path may be long, and than a process may have open files.
void make_deep_folders(const fs::path& top, int levels) {
  fs::create_directories(top);
  int folder = ::open(top.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  for (int level = 0; level < levels; ++level) {
    ASSERT_EQ(::mkdirat(folder, "d", 0755), 0);
    const int next = ::openat(folder, "d", O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    ::close(folder);
    folder = next;
  }
  ::close(::openat(folder, "file", O_WRONLY | O_CREAT | O_CLOEXEC, 0644));
  ::close(folder);
}

}  // namespace

TEST(RemoveTree, RemovesFoldersWithinEachOtherHoweverMany) {
  const orbs::structure::TestFolder scratch("remove-tree");
  const auto top = scratch.path() / "top";
  make_deep_folders(top, 3000);
  EXPECT_FALSE(orbs::remove_tree(top));
  EXPECT_FALSE(fs::exists(top));
}

TEST(RemoveTree, RemovesWhatMayNotBeWrittenToAndLinksThemselves) {
  const orbs::structure::TestFolder scratch("remove-tree-modes");
  const auto top = scratch.path() / "top";
  scratch.write("kept/file", "");
  scratch.write("top/a/b/file", "");
  fs::create_directory_symlink("../../kept", top / "a/link");
  for (const char* folder : {"a/b", "a"}) fs::permissions(top / folder, fs::perms::none);
  EXPECT_FALSE(orbs::remove_tree(top));
  EXPECT_FALSE(fs::exists(top));
  EXPECT_TRUE(fs::exists(scratch.path() / "kept/file"));
  EXPECT_FALSE(orbs::remove_tree(top));  // there is nothing
}

// Their bytes cannot be counted to the end.
TEST(FolderSize, OfVeryDeepFoldersIsMoreThanAnyLimit) {
  const orbs::structure::TestFolder scratch("folder-size");
  make_deep_folders(scratch.path() / "deep", 3000);
  EXPECT_EQ(orbs::supervisor::folder_size(scratch.path()), std::numeric_limits<std::size_t>::max());
  orbs::remove_tree(scratch.path() / "deep");
  scratch.write("a/b/file", "four");
  EXPECT_EQ(orbs::supervisor::folder_size(scratch.path()), 4U);
}
