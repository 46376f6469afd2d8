#include "adapters/process/private_parts.h"

#include "image/image_io.h"
#include "structure/source_files.h"

#include <algorithm>
#include <set>
#include <string>

#include <gtest/gtest.h>

namespace {

using namespace orbs;
using structure::TestFolder;

void write_image(const TestFolder& folder, const std::string& name, bool has_record) {
  auto image = image::make_image(4, 4, {"R", "G", "B"});
  if (has_record) image.attributes["orbs.spp"] = "64";
  std::filesystem::create_directories((folder.path() / name).parent_path());
  image::write_exr(image, folder.path() / name);
}

std::set<std::string> names_in(const TestFolder& folder, const std::vector<std::filesystem::path>& paths) {
  std::set<std::string> names;
  for (const auto& path : paths) names.insert(path.lexically_relative(folder.path()).generic_string());
  return names;
}

TEST(PrivateParts, RepositoriesRunsReferencesAndCasesAreFound) {
  const TestFolder folder("private-parts");
  for (const char* name : {"mine", "mine.py", ".git/HEAD", "lib/dependency/.hg/store", "bare.git/HEAD",
                           "bare.git/objects/x", "runs/monday/results.json", "runs/going-on/run.json",
                           "data/references/orbs/101.history.json", "cases/orbs/a1/scene.json"})
    folder.write(name, "{}");
  folder.write("cases/orbs/a1/case.json", "{\n  \"format\": \"orbs-case/2\"\n}");
  write_image(folder, "data/references/orbs/101.exr", true);
  write_image(folder, "textures/wood.exr", false);
  write_image(folder, "textures/copy.exr", true);
  std::filesystem::copy(folder.path() / "textures/copy.exr", folder.path() / "textures/table.bin");
  const auto& parts = adapters::private_parts(folder.path());
  EXPECT_EQ(names_in(folder, parts.folders),
            (std::set<std::string>{".git", "lib/dependency/.hg", "bare.git", "runs/monday", "runs/going-on",
                                   "data/references/orbs"}));
  EXPECT_EQ(names_in(folder, parts.files),
            (std::set<std::string>{"cases/orbs/a1/case.json", "textures/copy.exr", "textures/table.bin"}));
}

TEST(PrivateParts, LinksAreNotFollowed) {
  const TestFolder folder("private-links");
  const TestFolder elsewhere("private-elsewhere");
  elsewhere.write("results.json", "{}");
  std::filesystem::create_directory_symlink(elsewhere.path(), folder.path() / "link");
  std::filesystem::create_directory_symlink(folder.path(), folder.path() / "loop");
  EXPECT_TRUE(adapters::private_parts(folder.path()).folders.empty());
}

}  // namespace
