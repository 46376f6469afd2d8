// Sequential verdicts on simulated renders, whose error is known.
#include "base/error.h"
#include "base/files.h"
#include "structure/documentation.h"
#include "studies/looks/looks_text.h"

#include <filesystem>

#include <gtest/gtest.h>

using namespace orbs;
using namespace orbs::studies;

// Of three sequences none may do what is allowed once in a thousand. An error of three limits is found:
// fireflies hide that of the mean, and do not excuse it.
TEST(SimulatedLooks, RightImagesPassAndWrongOnesFail) {
  const auto rows = simulate_looks({.sequences = 3, .threads = 0, .seed = 7}, nullptr);
  ASSERT_EQ(rows.size(), 40U);
  for (const auto& row : rows) {
    const auto what = row.samples + " " + row.gate + " " + std::to_string(row.error);
    if (row.error < 1) {
      EXPECT_EQ(row.failed, 0) << what;
    }
    if (row.error > 1) {
      EXPECT_EQ(row.passed, 0) << what;
    }
    if (row.error > 2 && row.samples == "plain") {
      EXPECT_EQ(row.failed, row.sequences) << what;
    }
    if (row.error < 1 && row.samples == "plain") {
      EXPECT_EQ(row.passed, row.sequences) << what;
    }
  }
}

TEST(SimulatedLooks, AreTheSameForAnyNumberOfThreads) {
  const auto one = simulate_looks({.sequences = 1, .threads = 1}, nullptr);
  EXPECT_EQ(looks_csv(one), looks_csv(simulate_looks({.sequences = 1, .threads = 3}, nullptr)));
  EXPECT_EQ(looks_csv(read_looks_csv(looks_csv(one))), looks_csv(one));
  EXPECT_THROW(read_looks_csv("a,b\n"), InputError);
}

TEST(SimulatedLooks, ThePageShowsTheCommittedTable) {
  const std::filesystem::path docs = std::filesystem::path(ORBS_SOURCE_DIR) / "docs";
  const auto text = looks_text(read_looks_csv(read_file(docs / "reports/looks.csv")));
  EXPECT_EQ(orbs::structure::check_generated_part(docs / "understand/verdicts.md", "simulated looks", text),
            "");
}
