#include "run/other_images.h"

#include "structure/source_files.h"

#include <gtest/gtest.h>

namespace {

using orbs::run::misnamed_text;
using orbs::run::other_images;
using orbs::structure::TestFolder;

TEST(OtherImages, WhatTheRendererWroteUnderAnotherNameIsNamed) {
  for (const char* written :
       {"seed-2770001.exr", "seed-277.EXR", "seed-277.hdr", "out/seed-277.exr", "seed-277", "SEED-277.png",
        "seed-277.exr.part", "image.tif", "a/b/c/render.exr"}) {
    const TestFolder folder("other-images");
    folder.write("wood.png", "");
    const auto before = other_images(folder.path(), "seed-277.exr");
    EXPECT_EQ(misnamed_text("seed-277.exr", before, before), "");
    folder.write(written, "");
    folder.write("log.txt", "");
    EXPECT_EQ(misnamed_text("seed-277.exr", before, other_images(folder.path(), "seed-277.exr")),
              std::string(", but ") + written);
  }
}

TEST(OtherImages, TheNearestNamesComeFirst) {
  EXPECT_EQ(
      misnamed_text("seed-2.exr", {}, {"a.exr", "b.exr", "out/seed-2.exr", "seed-2_1.exr", "seed-2.exr"}),
      ", but out/seed-2.exr, seed-2_1.exr, a.exr and 1 more");
}

TEST(OtherImages, LinksAreNotFollowed) {
  const TestFolder folder("other-images-links");
  std::filesystem::create_directory_symlink("/", folder.path() / "seed-1");
  std::filesystem::create_symlink("/etc/hostname", folder.path() / "seed-1.hdr");
  EXPECT_TRUE(other_images(folder.path(), "seed-1.exr").empty());
}

}  // namespace
