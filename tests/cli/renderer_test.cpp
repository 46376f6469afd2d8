// Renderers that are added by configuration alone: a script in another language, and scenes written by hand.
#include "cli/sandbox.h"
#include "image/image_io.h"
#include "results/record.h"

#include <gtest/gtest.h>

using namespace orbs;
using cli_tests::contains;
using cli_tests::Sandbox;

namespace {

// Two emitting triangles halves of the view: what is left of the middle is orange, what is right of it blue.
// They lie 1 m ahead of a camera with tan(fov_y / 2) = 1/2, so that the image is 1 m high and 1.5 m wide
// there.
constexpr const char* kFlags = R"({"format": "orbs-scene/1", "name": "flags",
 "camera": {"position": [0,0,1], "look_at": [0,0,0], "fov_y": 53.13010235415598, "width": 12, "height": 8},
 "materials": [{"name": "orange", "type": "emission", "radiance": [1,0.5,0.25]},
               {"name": "blue", "type": "emission", "radiance": [0,0.125,1]}],
 "meshes": [{"name": "left", "generator": "plane", "half_size": 2, "material": "orange"},
            {"name": "right", "generator": "plane", "half_size": 2, "material": "blue"}],
 "instances": [{"mesh": "left", "matrix": [{"rotate_x": 90}, {"translate": [-2,0,0]}]},
               {"mesh": "right", "matrix": [{"rotate_x": 90}, {"translate": [2,0,0]}]}],
 "lights": []})";

void write_case(const Sandbox& sandbox) {
  sandbox.write("cases/m2_flags/flags.json", kFlags);
  sandbox.write("cases/m2_flags/case.json",
                R"({"format": "orbs-case/2", "requirement": "M2", "title": "Flags", "tests": "t",
 "typical_mistake": "m", "scenes": [{"name": "flags", "file": "flags.json", "spp": 1}]})");
  auto flags = image::make_image(12, 8, {"R", "G", "B"});
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 12; ++x) {
      flags.at(x, y, 0) = x < 6 ? 1.0F : 0.0F;
      flags.at(x, y, 1) = x < 6 ? 0.5F : 0.125F;
      flags.at(x, y, 2) = x < 6 ? 0.25F : 1.0F;
    }
  image::write_exr(flags, sandbox.folder() / "references" / "flags.exr");
}

}  // namespace

TEST(AddedRenderer, InAnotherLanguagePassesWithoutFurtherEdits) {
  const Sandbox sandbox;
  write_case(sandbox);
  const auto added =
      sandbox.orbs({"renderer", "add", "emitter", "--executable",
                    ORBS_SOURCE_DIR "/tests/cli/emitter_renderer.py", "--declares", "G1/M2-(1)"});
  EXPECT_EQ(added.status, 0) << added.text;
  EXPECT_TRUE(contains(added.text, "then: orbs doctor; orbs run -r emitter")) << added.text;
  const auto answer = sandbox.orbs({"run", "-r", "emitter", "-c", "m2_flags", "-o", "out"});
  EXPECT_EQ(answer.status, 0) << answer.text << sandbox.read("out/emitter/flags/log.txt");
  const auto job = results::read_job_file(sandbox.folder() / "out/emitter/flags/job.json");
  EXPECT_EQ(job.targets.at(0).verdict, results::Verdict::Pass);
  EXPECT_EQ(job.job.program.version, "emitter renderer 1.0");
  EXPECT_EQ(job.job.files.native_scene, "");
  // The built-in tracer sees the same.
  sandbox.orbs({"renderer", "add", "tracer", "--executable", "{build}/orbs-tracer", "--declares", "G5/M8"});
  const auto tracer = sandbox.orbs({"run", "-r", "tracer", "-c", "m2_flags"});
  EXPECT_EQ(tracer.status, 0) << tracer.text;
}

TEST(AddedRenderer, MaySayItsTimeInAFile) {
  const Sandbox sandbox;
  write_case(sandbox);
  sandbox.orbs({"renderer", "add", "emitter", "--executable",
                ORBS_SOURCE_DIR "/tests/cli/emitter_renderer.py", "--declares", "G1/M2"});
  auto text = sandbox.read("configuration.json");
  const std::string line = R"("scene_format": "orbs-scene",)";
  text.insert(
      text.find(line),
      R"("render_seconds": {"file": "times.json", "key": "render/milliseconds", "unit_seconds": 0.001}, )");
  sandbox.write("configuration.json", text);
  sandbox.orbs({"run", "-r", "emitter", "-c", "m2_flags", "-o", "out"});
  const auto job = results::read_job_file(sandbox.folder() / "out/emitter/flags/job.json").job;
  ASSERT_TRUE(job.cost.render_seconds);
  EXPECT_GT(*job.cost.render_seconds, 0);
  EXPECT_LT(*job.cost.render_seconds, job.cost.wall_seconds);
}

TEST(AddedRenderer, WithATakenNameIsRefused) {
  const Sandbox sandbox;
  const auto before = sandbox.read("configuration.json");
  const auto answer = sandbox.orbs({"renderer", "add", "good"});
  EXPECT_EQ(answer.status, 2);
  EXPECT_TRUE(contains(answer.text, "has a renderer 'good' already")) << answer.text;
  EXPECT_EQ(sandbox.read("configuration.json"), before);
}

TEST(AddedRenderer, WhoseCommandOrNameCannotWorkIsRefused) {
  const Sandbox sandbox;
  const auto before = sandbox.read("configuration.json");
  const auto answer =
      sandbox.orbs({"renderer", "add", "m6", "--executable", "/bin/sh", "--", "-c", "{scene}", "{output}"});
  EXPECT_EQ(answer.status, 2) << answer.text;
  EXPECT_TRUE(contains(answer.text, "/command/0: must be a program or {executable}, is '-c'")) << answer.text;
  EXPECT_EQ(sandbox.orbs({"renderer", "add", "junit.xml"}).status, 2);
  EXPECT_EQ(sandbox.orbs({"renderer", "add", std::string(300, 'x')}).status, 2);
  EXPECT_EQ(sandbox.read("configuration.json"), before);
}

// A shell script that takes its "scene" to be the name of a finished image.
TEST(HandWrittenScene, IsUsedInPlaceOfTheExportedOneAndKeptApart) {
  const Sandbox sandbox;
  write_case(sandbox);
  const auto added = sandbox.orbs({"renderer", "add", "art", "--executable", "/bin/sh", "--format", "native",
                                   "--native-scenes", "arm", "--declares", "G1/M2", "--", "{executable}",
                                   "-c", "cp \"$(cat \"$1\")\" \"$2\"", "art", "{scene}", "{output}"});
  EXPECT_EQ(added.status, 0) << added.text;
  const std::vector<std::string> run{"run", "-r", "art", "-c", "m2_flags", "-o", "out"};
  const auto without = sandbox.orbs({"run", "-r", "art", "-c", "m2_flags", "--dry-run"});
  EXPECT_TRUE(contains(without.text, "unsupported: it reads hand-written scenes only, and there is no "))
      << without.text;
  EXPECT_TRUE(contains(without.text, "cases/m2_flags/art/flags.arm")) << without.text;
  sandbox.write("cases/m2_flags/art/flags.arm", "parts/flags.exr");
  std::filesystem::create_directories(sandbox.folder() / "cases/m2_flags/art/parts");
  std::filesystem::copy_file(sandbox.folder() / "references/flags.exr",
                             sandbox.folder() / "cases/m2_flags/art/parts/flags.exr");
  const auto answer = sandbox.orbs(run);
  EXPECT_EQ(answer.status, 0) << answer.text;
  const auto job = results::read_job_file(sandbox.folder() / "out/art/flags/job.json").job;
  EXPECT_EQ(job.files.native_scene, "cases/m2_flags/art/flags.arm");
  EXPECT_TRUE(sandbox.has("out/art/flags/flags.arm"));
  EXPECT_EQ(sandbox.orbs({"probe", "-r", "art", "-s", "flags"}).status, 1);  // nothing could be checked
  // What it includes belongs to it.
  sandbox.write("cases/m2_flags/art/parts/note.txt", "new");
  const auto resumed = sandbox.orbs({"run", "--resume", "out"});
  EXPECT_TRUE(contains(resumed.text, "art flags: its scene has changed")) << resumed.text;
}

TEST(HandWrittenScene, LeavesOtherScenesOfItsRendererToTheExporter) {
  const Sandbox sandbox;
  write_case(sandbox);
  sandbox.write("cases/m2_flags/mixed/flags.json", "{ \"a scene\": \"of its own\" }");
  sandbox.orbs({"renderer", "add", "mixed", "--executable", "/bin/sh", "--native-scenes", "json",
                "--declares", "G1/M2", "--", "{executable}", "-c", "head -c 40 \"$1\"; exit 3", "mixed",
                "{scene}", "{output}"});
  sandbox.orbs({"run", "-r", "mixed", "-s", "flags,grey", "-o", "out"});
  EXPECT_TRUE(contains(sandbox.read("out/mixed/flags/log.txt"), "of its own"));
  EXPECT_TRUE(contains(sandbox.read("out/mixed/grey/log.txt"), "orbs-scene/1"));
}
