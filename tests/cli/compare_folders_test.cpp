#include "cli/sandbox.h"
#include "image/image_io.h"
#include "json/document.h"
#include "json/object_reader.h"

#include <algorithm>

#include <gtest/gtest.h>

using namespace orbs;
using namespace orbs::cli_tests;

namespace {

void write_grey(const Sandbox& sandbox, const std::string& file, float value, int width_px = 12) {
  auto grey = image::make_image(width_px, 8, {"R", "G", "B"});
  std::fill(grey.pixels.begin(), grey.pixels.end(), value);
  std::filesystem::create_directories((sandbox.folder() / file).parent_path());
  image::write_exr(grey, sandbox.folder() / file);
}

struct Stand {
  Stand() {
    for (const char* file : {"a/same.exr", "b/same.exr", "b/below/near.exr", "b/far.exr", "a/only-a.exr",
                             "b/only-b.exr", "b/size.exr"})
      write_grey(sandbox, file, 0.5F);
    write_grey(sandbox, "a/below/near.exr", 0.48F);
    write_grey(sandbox, "a/far.exr", 0.2F);
    write_grey(sandbox, "a/size.exr", 0.5F, 10);
    sandbox.write("a/notes.txt", "no image");
  }
  Sandbox sandbox;
};

}  // namespace

TEST(CompareFolders, PairsImagesByNameAndShowsTheWorstFirst) {
  const Stand stand;
  const auto answer = stand.sandbox.orbs({"compare", "a", "b"});
  EXPECT_EQ(answer.status, 1) << answer.text;
  const auto at = [&](const char* part) {
    EXPECT_TRUE(contains(answer.text, part)) << part << "\n" << answer.text;
    return answer.text.find(part);
  };
  EXPECT_LT(at("only-a.exr"), at("far.exr"));
  EXPECT_LT(at("far.exr"), at("below/near.exr"));
  EXPECT_LT(at("below/near.exr"), at("same.exr"));
  at("is missing in b");
  at("is missing in a");
  at("cannot be compared");
  at("6 images: 0 beyond the tolerance, 3 missing or not comparable");
  EXPECT_FALSE(contains(answer.text, "notes.txt")) << answer.text;
}

TEST(CompareFolders, ExitStatusIsThatOfTheToleranceAndOfWhatIsMissing) {
  const Stand stand;
  for (const char* file : {"a/only-a.exr", "b/only-b.exr", "a/size.exr", "b/size.exr"})
    std::filesystem::remove(stand.sandbox.folder() / file);
  EXPECT_EQ(stand.sandbox.orbs({"compare", "a", "b"}).status, 0);
  const auto strict = stand.sandbox.orbs({"compare", "a", "b", "--min", "20"});
  EXPECT_EQ(strict.status, 1);
  EXPECT_TRUE(contains(strict.text, "3 images: 1 beyond the tolerance, 0 missing")) << strict.text;
  EXPECT_EQ(stand.sandbox.orbs({"compare", "a", "b", "--metric", "mse", "--max", "0.2"}).status, 0);
  EXPECT_EQ(stand.sandbox.orbs({"compare", "a/far.exr", "b"}).status, 2);
  stand.sandbox.shell("mkdir empty none");
  EXPECT_EQ(stand.sandbox.orbs({"compare", "empty", "none"}).status, 2);
}

TEST(CompareFolders, WritesAPageInOneFileAndJson) {
  const Stand stand;
  EXPECT_EQ(stand.sandbox.orbs({"compare", "a", "b", "-o", "page.html"}).status, 1);
  const auto page = stand.sandbox.read("page.html");
  EXPECT_LT(page.find("far.exr"), page.find("below/near.exr"));
  EXPECT_TRUE(contains(page, "src=\"data:image/png;base64,"));
  EXPECT_FALSE(contains(page, "http"));
  const auto document = json::parse("json", stand.sandbox.orbs({"compare", "a", "b", "--json"}).text);
  json::ObjectReader in(document);
  EXPECT_EQ(in.text("format"), "orbs-folder-comparison/1");
  EXPECT_EQ(in.objects("pairs").size(), 6U);
}

TEST(CompareFolders, NothingThatLooksLikeAnImageIsLeftOutWithoutAWord) {
  const Sandbox sandbox;
  write_grey(sandbox, "a/case.exr", 0.5F);
  write_grey(sandbox, "b/case.exr", 0.5F);
  sandbox.shell("mv a/case.exr a/case.EXR");
  const auto alike = sandbox.orbs({"compare", "a", "b"});
  EXPECT_EQ(alike.status, 0) << alike.text;
  EXPECT_TRUE(contains(alike.text, "1 images: 0 beyond the tolerance, 0 missing")) << alike.text;
  sandbox.shell(
      "cp a/case.EXR a/K.EXR; cp a/case.EXR a/depth.tif; ln -s nowhere b/gone.png; cp a/K.EXR a/case.Exr");
  const auto answer = sandbox.orbs({"compare", "a", "b"});
  EXPECT_EQ(answer.status, 1);
  for (const char* part : {"K.EXR", "is missing in b", "depth.tif", "is of a format that is not read, in a",
                           "gone.png", "is no file in b", "has the name of another image in a",
                           "5 images: 0 beyond the tolerance, 4 missing or not comparable"})
    EXPECT_TRUE(contains(answer.text, part)) << part << "\n" << answer.text;
}

// Nothing else is there.
TEST(CompareFolders, ImagesThatCannotBeReadAloneAreNamed) {
  const Sandbox sandbox;
  sandbox.shell("mkdir a b; echo x > a/K.tiff");
  const auto answer = sandbox.orbs({"compare", "a", "b"});
  EXPECT_EQ(answer.status, 1) << answer.text;
  EXPECT_TRUE(contains(answer.text, "K.tiff")) << answer.text;
}
