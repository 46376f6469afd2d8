#include "adapters/native_scene.h"

#include "base/error.h"
#include "base/files.h"
#include "structure/source_files.h"

#include <gtest/gtest.h>

using namespace orbs;
using structure::TestFolder;

namespace {

registry::Renderer renderer() {
  registry::Renderer entry;
  entry.name = "art";
  entry.format.native_scenes = "arm";
  return entry;
}

}  // namespace

TEST(NativeScene, LiesInTheRenderersFolderOfTheCase) {
  const TestFolder scratch("native-place");
  const auto neutral = scratch.path() / "m1" / "grey.json";
  EXPECT_EQ(adapters::native_scene(renderer(), neutral, "v1.5"), "");
  scratch.write("m1/art/v1.5.arm", "a scene");
  EXPECT_EQ(adapters::native_scene(renderer(), neutral, "v1.5"), scratch.path() / "m1/art/v1.5.arm");
  EXPECT_EQ(adapters::native_scene(renderer(), neutral, "grey"), "");
  auto other = renderer();
  other.format.native_scenes = "";
  EXPECT_EQ(adapters::native_scene(other, neutral, "v1.5"), "");
}

TEST(NativeScene, HasAHashOfAllThatItMayInclude) {
  const TestFolder scratch("native-hash");
  scratch.write("art/a.arm", "include b");
  scratch.write("art/parts/b.arm", "one");
  const auto hash = [&] { return adapters::native_scene_hash(scratch.path() / "art/a.arm"); };
  const auto before = hash();
  EXPECT_EQ(hash(), before);
  scratch.write("art/parts/b.arm", "two");
  const auto after = hash();
  EXPECT_NE(after, before);
  scratch.write("art/parts/b.arm", "one");
  EXPECT_EQ(hash(), before);
  std::filesystem::rename(scratch.path() / "art/parts/b.arm", scratch.path() / "art/parts/c.arm");
  EXPECT_NE(hash(), before);
}

TEST(NativeScene, IsCopiedWithItsFolder) {
  const TestFolder scratch("native-copy");
  scratch.write("art/a.arm", "scene");
  scratch.write("art/parts/b.ply", "mesh");
  adapters::copy_native_scene(scratch.path() / "art/a.arm", scratch.path() / "job");
  EXPECT_EQ(read_file(scratch.path() / "job/a.arm"), "scene");
  EXPECT_EQ(read_file(scratch.path() / "job/parts/b.ply"), "mesh");
}

TEST(NativeScene, BringsNoLinksAndNoImageOfItsOwn) {
  const TestFolder scratch("native-refused");
  scratch.write("art/a.arm", "scene");
  std::filesystem::create_symlink("/etc/passwd", scratch.path() / "art/mesh");
  const auto copy = [&] {
    adapters::copy_native_scene(scratch.path() / "art/a.arm", scratch.path() / "job");
  };
  EXPECT_THROW(copy(), InputError);
  EXPECT_THROW(adapters::native_scene_hash(scratch.path() / "art/a.arm"), InputError);
  std::filesystem::remove(scratch.path() / "art/mesh");
  EXPECT_NO_THROW(copy());
  scratch.write("art/result.exr", "an old image");
  EXPECT_THROW(copy(), InputError);
}
