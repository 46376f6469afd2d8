// What the server and the one-file page make of the folder of a cost study.
#include "base/error.h"
#include "base/files.h"
#include "page/fixture_cost.h"
#include "report/page_file.h"
#include "results/study_kinds.h"
#include "structure/source_files.h"
#include "unit/server/client.h"

#include <gtest/gtest.h>

using namespace orbs;

namespace {

bool holds(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

// One target whose reference and points are these files.
std::string study_with(const std::string& reference, const std::string& points) {
  return R"({"format": "orbs-cost/2", "started": "2026-01-02T03:04:05", "targets": [{"reference": ")" +
         reference + R"("}], "curves": [{"points": [)" + points + "]}]}";
}

}  // namespace

TEST(CostStudy, NamesReferencesAndTheLastSettingsFirst) {
  const structure::TestFolder scratch("cost-study");
  page_tests::write_cost_study(scratch.path());
  const auto study = results::read_study_folder(scratch.path());
  EXPECT_EQ(study.kind.name, "cost");
  EXPECT_EQ(study.started, "2026-01-02T03:04:05");
  ASSERT_EQ(study.images.size(), 6U + 3U * 6U * 6U);
  EXPECT_EQ(study.images.front(), "images/reference/101.exr");
  EXPECT_EQ(study.images.at(6), "images/orbs/101/5.png");
  EXPECT_EQ(study.images.back(), "images/povray/g4-lambert/0.png");
}

TEST(CostStudy, OfAnotherFormatIsRefusedWithItsPlace) {
  const structure::TestFolder scratch("cost-format");
  EXPECT_EQ(results::study_kind_in(scratch.path()), nullptr);
  EXPECT_THROW(results::read_study_folder(scratch.path()), InputError);
  scratch.write("cost.json", R"({"format": "orbs-cost/9"})");
  try {
    results::read_study_folder(scratch.path());
    FAIL() << "it was read";
  } catch (const InputError& e) {
    EXPECT_TRUE(holds(e.what(), "cost.json:1:")) << e.what();
    EXPECT_TRUE(holds(e.what(), "orbs-cost/2")) << e.what();
  }
}

TEST(CostPageFile, HoldsTheStudyAsItIsAndKeepsToItsSize) {
  const structure::TestFolder scratch("cost-page");
  page_tests::write_cost_study(scratch.path() / "study");
  scratch.write("web/single.html", "before<!--orbs-data-->after");
  const auto all = report::study_page_file(scratch.path() / "study", {scratch.path() / "web", 10'000'000});
  EXPECT_EQ(all.images, 6U + 3U * 6U * 6U);
  EXPECT_TRUE(all.left_out.empty());
  EXPECT_TRUE(holds(all.text, R"("name": "study")"));
  EXPECT_FALSE(holds(all.text, "<b>test")) << "text of the study stands there as markup";
  EXPECT_TRUE(holds(all.text, "\\u003cb>test"));
  // The references come first.
  const auto few = report::study_page_file(scratch.path() / "study", {scratch.path() / "web", 30'000});
  EXPECT_GT(few.images, 0U);
  EXPECT_TRUE(holds(few.text, R"("images/reference/101.exr": "image-0")"));
  EXPECT_EQ(few.images + few.left_out.size(), all.images);
}

// Somebody else's cost.json may name any file of this machine.
TEST(CostPageFile, NamesOfFilesOutsideTheStudyLeadNowhere) {
  const structure::TestFolder scratch("cost-outside");
  scratch.write("secret.png", "secret");
  scratch.write("web/single.html", "<!--orbs-data-->");
  for (const auto& name : {(scratch.path() / "secret.png").string(), std::string("../secret.png")}) {
    scratch.write("study/cost.json", study_with("images/none.exr", R"({"image": ")" + name + R"("})"));
    const auto page = report::study_page_file(scratch.path() / "study", {scratch.path() / "web", 1000});
    EXPECT_EQ(page.images, 0U) << name;
    EXPECT_EQ(page.left_out.size(), 2U) << name;
  }
}

TEST(ServerStudy, ServesTheFilesOfAStudyAsTheyAre) {
  const structure::TestFolder scratch("served-study");
  page_tests::write_cost_study(scratch.path());
  const server_tests::RunningServer server(scratch.path());
  const auto runs = server.get("/data/runs.json");
  EXPECT_TRUE(holds(runs, R"("kind": "cost")")) << runs;
  EXPECT_TRUE(holds(runs, R"("started": "2026-01-02T03:04:05")")) << runs;
  EXPECT_EQ(server_tests::body_of(server.get("/data/0/file/cost.json")),
            read_file(scratch.path() / "cost.json"));
  EXPECT_EQ(server_tests::status_of(server.get("/data/0/image/images/reference/101.exr")), 200);
  EXPECT_EQ(server_tests::status_of(server.get("/data/0/file/images/orbs/101/0.png")), 200);
  for (const char* address : {"/data/0/overview.json", "/data/0/target/0.json", "/data/0/events"})
    EXPECT_EQ(server_tests::status_of(server.get(address)), 404) << address;
}
