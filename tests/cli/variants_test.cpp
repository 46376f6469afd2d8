// Variants of a renderer, arguments of scenes, and references that are accepted beside a scene's own.
#include "cli/sandbox.h"
#include "image/image.h"
#include "image/image_io.h"

#include <gtest/gtest.h>

using orbs::cli_tests::contains;
using orbs::cli_tests::replace_in;
using orbs::cli_tests::Sandbox;

namespace {

constexpr const char* kVariants =
    R"(, "variants": [{"name": "a", "arguments": []}, {"name": "b", "arguments": ["--grey", "0.5"]},
      {"name": "dark", "arguments": ["--grey", "0.2"]}])";

void write_grey(const Sandbox& sandbox, const std::string& file, float value) {
  auto image = orbs::image::make_image(12, 8, {"R", "G", "B"});
  std::fill(image.pixels.begin(), image.pixels.end(), value);
  orbs::image::write_exr(image, sandbox.folder() / file);
}

}  // namespace

TEST(Variants, AreRenderersOfTheirOwnAndComparedWithTheFirst) {
  const Sandbox sandbox;
  sandbox.add_to_good(kVariants);
  const auto answer = sandbox.orbs({"run", "-r", "good", "-s", "grey", "-o", "out"});
  EXPECT_EQ(answer.status, 1) << answer.text;
  for (const char* name : {"good-a", "good-b", "good-dark"})
    EXPECT_TRUE(sandbox.has(std::string("out/") + name + "/grey/result.exr")) << name;
  EXPECT_TRUE(contains(answer.text, "good-b against good-a: 2 targets, the same but for noise"))
      << answer.text;
  EXPECT_TRUE(contains(answer.text, "good-dark against good-a: 2 targets, ")) << answer.text;
  EXPECT_TRUE(contains(answer.text, "M1 grey: verdict, fail against pass")) << answer.text;
}

TEST(Variants, CanBeChosenOneByOne) {
  const Sandbox sandbox;
  sandbox.add_to_good(kVariants);
  const auto answer = sandbox.orbs({"run", "-r", "good-b", "-s", "grey", "--dry-run"});
  EXPECT_EQ(answer.status, 0) << answer.text;
  EXPECT_TRUE(contains(answer.text, "--grey 0.5")) << answer.text;
  EXPECT_FALSE(contains(answer.text, "good-a")) << answer.text;
}

TEST(Variants, WithTheNameOfAnotherRendererAreRefusedWithTheirPlace) {
  const Sandbox sandbox;
  sandbox.add_to_good(R"(, "variants": [{"name": "a", "arguments": []}, {"name": "a", "arguments": []}])");
  const auto answer = sandbox.orbs({"run", "-r", "good", "--dry-run"});
  EXPECT_EQ(answer.status, 2);
  EXPECT_TRUE(contains(answer.text, "configuration.json:")) << answer.text;
  EXPECT_TRUE(contains(answer.text, "'good-a' is the name of an earlier renderer")) << answer.text;
}

TEST(Arguments, OfASceneGoToTheRendererThatTheyAreFor) {
  const Sandbox sandbox;
  replace_in(sandbox, "cases/m1_grey/case.json", R"("name": "v1.5",)",
             R"("name": "v1.5", "arguments": {"good": ["--grey", "0.25", "--note", "{seed}"]},)");
  const auto answer = sandbox.orbs({"run", "-r", "good,noisy", "-c", "m1_grey", "--dry-run", "--seed", "7"});
  EXPECT_EQ(answer.status, 0) << answer.text;
  EXPECT_TRUE(contains(answer.text, "--grey 0.25 --note 7\n")) << answer.text;
  EXPECT_EQ(answer.text.find("--note 7"), answer.text.rfind("--note 7")) << answer.text;
  replace_in(sandbox, "cases/m1_grey/case.json", "{seed}", "{sead}");
  const auto unknown = sandbox.orbs({"run", "-r", "good", "--dry-run"});
  EXPECT_EQ(unknown.status, 2);
  EXPECT_TRUE(contains(unknown.text, "unknown placeholder {sead} (did you mean 'seed'?)")) << unknown.text;
}

TEST(AcceptedReference, MakesAnImagePassThatFailsByItsOwnAndTheReportSaysSo) {
  const Sandbox sandbox;
  write_grey(sandbox, "references/mirror.exr", 0.2F);
  EXPECT_EQ(sandbox.orbs({"run", "-r", "dark", "-s", "grey", "-c", "m1_grey"}).status, 1);
  replace_in(
      sandbox, "cases/m1_grey/case.json", R"({"name": "grey", "file": "grey.json", "spp": 8})",
      R"({"name": "grey", "file": "grey.json", "spp": 8, "accepted": [{"reference": "mirror", "reason": "left open by G1"}]})");
  replace_in(
      sandbox, "cases/m3_mirror/case.json", R"({"name": "grey", "file": "../m1_grey/grey.json", "spp": 8})",
      R"({"name": "grey", "file": "../m1_grey/grey.json", "spp": 8, "accepted": [{"reference": "mirror", "reason": "left open by G1"}]})");
  const auto answer = sandbox.orbs({"run", "-r", "dark", "-s", "grey", "-c", "m1_grey", "-o", "out"});
  EXPECT_EQ(answer.status, 0) << answer.text;
  EXPECT_TRUE(
      contains(answer.text, "judged by the reference of 'mirror', which is accepted, too: left open by G1"))
      << answer.text;
  EXPECT_TRUE(contains(sandbox.read("out/results.json"), "\"reference_image\": \"references/mirror.exr\""));
  // The same image still passes by its own reference, which comes first.
  const auto good = sandbox.orbs({"run", "-r", "good", "-s", "grey", "-c", "m1_grey"});
  EXPECT_EQ(good.status, 0) << good.text;
  EXPECT_FALSE(contains(good.text, "which is accepted")) << good.text;
  // What neither allows fails.
  EXPECT_EQ(sandbox.orbs({"run", "-r", "nan", "-s", "grey", "-c", "m1_grey"}).status, 1);
}

TEST(AcceptedReference, OfASceneThatIsNotThereIsRefused) {
  const Sandbox sandbox;
  replace_in(
      sandbox, "cases/m1_grey/case.json", R"({"name": "v1.5", "file": "grey.json", "spp": 8})",
      R"({"name": "v1.5", "file": "grey.json", "spp": 8, "accepted": [{"reference": "miror", "reason": "r"}]})");
  const auto answer = sandbox.orbs({"run", "-r", "good"});
  EXPECT_EQ(answer.status, 2);
  EXPECT_TRUE(contains(answer.text, "has that name (did you mean 'mirror'?)")) << answer.text;
}
