// The command works and its numbers are there; how large they are is for people on a quiet machine.
#include "cli/sandbox.h"
#include "json/document.h"
#include "json/object_reader.h"

#include <gtest/gtest.h>

using namespace orbs;
using cli_tests::Sandbox;

TEST(Bench, PrintsATableAndWritesAllNumbers) {
  const Sandbox sandbox;
  const auto answer =
      sandbox.orbs({"bench", "--configuration", ORBS_SOURCE_DIR "/configuration.json", "--only", "orbs",
                    "--side", "32", "--spp", "256", "--rounds", "2", "--threads", "1"});
  ASSERT_EQ(answer.status, 0) << answer.text;
  EXPECT_NE(answer.text.find("million camera paths per CPU second"), std::string::npos) << answer.text;
  const auto document = json::parse("bench.json", sandbox.read("bench.json"));
  json::ObjectReader bench(document);
  EXPECT_GT(bench.number("metrics_cpu_ms"), 0);
  EXPECT_GT(bench.number("equal_cpu_seconds"), 0);
  auto overhead = bench.object("overhead");
  auto bare_ms = overhead.object("bare_ms");
  auto harness_ms = overhead.object("harness_ms");
  EXPECT_GT(bare_ms.number("least"), 0);
  EXPECT_GT(harness_ms.number("least"), 0);
  // Of two renders on a busy machine the one with the harness may be the quicker: its sign is no fact.
  EXPECT_NEAR(overhead.number("added_ms"), harness_ms.number("median") - bare_ms.number("median"), 1e-6);
  EXPECT_GT(overhead.number("watching_share"), 0);
  auto start = bench.object("start");
  for (const char* program : {"orbs_version_ms", "tracer_version_ms", "pixel_ms"})
    EXPECT_GT(start.object(program).number("least"), 0) << program;
  EXPECT_NE(answer.text.find("orbs-tracer, 1 x 1 px: CPU ms"), std::string::npos) << answer.text;
  auto renderers = bench.objects("renderers");
  ASSERT_EQ(renderers.size(), 1U);
  EXPECT_EQ(renderers[0].text("name"), "orbs");
  EXPECT_GT(renderers[0].object("camera_paths_per_cpu_second").number("least"), 0);
  EXPECT_GT(renderers[0].object("noise").number("relative_mse"), 0);
  EXPECT_GT(renderers[0].object("noise").number("psnr_srgb8_db"), 10);
  const double share = renderers[0].object("traversal_share").number("median");
  EXPECT_GT(share, 0);
  EXPECT_LT(share, 1);
  EXPECT_EQ(renderers[0].objects("rounds").size(), 2U);
}

TEST(Bench, ARendererThatGivesNoImageIsNamedWithItsLastWords) {
  const Sandbox sandbox;
  sandbox.write("data/bench/cornell-box.json", sandbox.read("cases/m1_grey/grey.json"));
  const auto answer = sandbox.orbs({"bench", "--only", "exit3", "--side", "16", "--spp", "2"});
  EXPECT_EQ(answer.status, 2);
  EXPECT_NE(answer.text.find("renderer 'exit3' ended with exit code 3; its last words: fake: cannot find"),
            std::string::npos)
      << answer.text;
  EXPECT_FALSE(sandbox.has("bench.json"));
}

TEST(Bench, ARendererThatIsNamedMustBeThere) {
  const Sandbox sandbox;
  const auto answer = sandbox.orbs({"bench", "--only", "absent"});
  EXPECT_EQ(answer.status, 2);
  EXPECT_NE(answer.text.find("/nowhere/at/all"), std::string::npos) << answer.text;
}

// Of `orbs run` it is a share of the scenes' size.
TEST(Bench, PixelsAreNoSize) {
  const Sandbox sandbox;
  for (const char* command : {"bench", "probe", "stability", "effect-cost"}) {
    const auto answer = sandbox.orbs({command, "--size", "64"});
    EXPECT_EQ(answer.status, 2) << command;
    EXPECT_EQ(answer.text.find("orbs: --size: is a share"), 0u) << answer.text;
    EXPECT_NE(answer.text.find("--side 64"), std::string::npos) << answer.text;
    const auto without = sandbox.orbs({command, "--size"});
    EXPECT_EQ(without.status, 2) << command;
    EXPECT_EQ(without.text.find("orbs: --size"), 0u) << without.text;
    EXPECT_EQ(sandbox.orbs({command, "--help"}).text.find("--size"), std::string::npos) << command;
  }
}
