// Mistakes that no change of an image can make are named by making them.
#include "base/files.h"
#include "cli/sandbox.h"

#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

using namespace orbs;
using cli_tests::Sandbox;

namespace {

std::string renderer(const std::string& name, const std::string& fault) {
  return fmt::format(
      R"entry({{"name": "{}", "executable": "{{build}}/orbs-tracer", "declares": "G5/M8/L4/A4/B1/C5/D6/N5/S7",
  "command": ["{{executable}}", "{{scene}}", "-o", "{{output}}", "--spp", "{{spp}}", "--seed", "{{seed}}",
              "--threads", "{{threads}}"{}]}})entry",
      name, fault.empty() ? "" : fmt::format(R"(, "--fault", "{}")", fault));
}

void write_configuration(const Sandbox& sandbox) {
  std::string entries = renderer("orbs", "");
  for (const char* fault : {"environment-quarter-turn", "environment-mirrored", "spot-full-angles",
                            "lens-diameter", "roughness-not-squared", "normal-map-flipped",
                            "frames-without-sign", "frames-with-sign-of-mesh", "opacity-inverted"})
    entries += ",\n" + renderer(fault, fault);
  sandbox.write("configuration.json", fmt::format(R"({{"format": "orbs-configuration/1", "stands_alone": true,
"defaults": {{"suite": "everyday"}}, "suites": [{{"name": "everyday", "cases": "{0}/data/cases/everyday",
"references": "{0}/data/references/everyday"}}], "renderers": [{1}]}})",
                                                  ORBS_SOURCE_DIR, entries));
}

// What orbs explain says of the image that the renderer of that mistake makes of the scene.
std::string explained(const Sandbox& sandbox, const std::string& mistake, const std::string& scene) {
  const std::string folder = "out-" + mistake + scene;
  sandbox.orbs({"run", "-q", "-r", mistake, "-s", scene, "-o", folder});
  return sandbox.orbs({"explain", folder}).text;
}

}  // namespace

TEST(Explain, NamesTheMistakeThatMakesTheSameImage) {
  const Sandbox sandbox;
  write_configuration(sandbox);
  for (const auto& [mistake, scene] :
       {std::pair{"environment-quarter-turn", "d5-ball"}, std::pair{"environment-mirrored", "d5-turned"},
        std::pair{"spot-full-angles", "d2-table"}, std::pair{"lens-diameter", "c1-plane"},
        std::pair{"roughness-not-squared", "metal-ball-02"}, std::pair{"normal-map-flipped", "n1-above"},
        std::pair{"frames-without-sign", "n1-above"}, std::pair{"frames-with-sign-of-mesh", "n1-above"},
        std::pair{"opacity-inverted", "n3-mask"}}) {
    const auto text = explained(sandbox, mistake, scene);
    EXPECT_NE(text.find(fmt::format("{}  {}  {}: ", mistake, scene, mistake)), std::string::npos) << text;
  }
}

TEST(Explain, SaysWhatItTriedWhereNothingFitsAndThatNothingFails) {
  const Sandbox sandbox;
  write_configuration(sandbox);
  const auto right = explained(sandbox, "orbs", "d5-ball");
  EXPECT_NE(right.find("no image of"), std::string::npos) << right;
  const auto turned = explained(sandbox, "environment-quarter-turn", "d5-ball");
  // The same scene under a sky that is turned in another way: a mistake that is not known.
  const auto image_of = [&](const std::string& scene) {
    return sandbox.folder() / ("out-environment-quarter-turn" + scene) / "environment-quarter-turn" / scene /
           "result.exr";
  };
  explained(sandbox, "environment-quarter-turn", "d5-turned");
  write_file(image_of("d5-ball"), read_file(image_of("d5-turned")));
  const auto text = sandbox.orbs({"explain", "out-environment-quarter-turnd5-ball"}).text;
  EXPECT_NE(text.find("none of these: "), std::string::npos) << text;
  EXPECT_NE(text.find("environment-mirrored"), std::string::npos) << text;
}
