#include "registry/configuration.h"

#include "base/error.h"
#include "json/locate.h"
#include "registry/renderer_variants.h"
#include "structure/source_files.h"

#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

using orbs::registry::Configuration;
using orbs::registry::load_configuration;
using orbs::structure::TestFolder;

namespace {

std::string with_renderer(const std::string& members) {
  return R"({"format": "orbs-configuration/1",
 "suites": [{"name": "s", "cases": "c", "references": "r"}],
 "renderers": [{)" +
         members + "}]}";
}

const std::string kRenderer =
    R"("name": "a", "executable": "{build}/a", "declares": "G1/M2", "command": ["{executable}", "{scene}", "-o{output}"])";

Configuration load(const std::string& text) {
  const TestFolder scratch("registry-configuration");
  scratch.write("configuration.json", text);
  return load_configuration(scratch.path() / "configuration.json");
}

// The first line of the error without the folder of the file.
std::string message_of(const std::string& text) {
  try {
    load(text);
  } catch (const orbs::InputError& e) {
    const std::string what = e.what();
    const auto begin = what.find("configuration.json");
    return what.substr(begin, what.find('\n', begin) - begin);
  }
  return "no error";
}

}  // namespace

TEST(Configuration, ASmallEntryIsCompleteAndTheRestHasDefaults) {
  const auto configuration = load(with_renderer(kRenderer));
  ASSERT_EQ(configuration.renderers.size(), 1U);
  const auto& renderer = configuration.renderers[0];
  EXPECT_EQ(renderer.name, "a");
  EXPECT_EQ(renderer.support.declares, orbs::registry::parse_features("G1/M2"));
  EXPECT_EQ(renderer.limits.wall_seconds, 600);
  EXPECT_FALSE(renderer.limits.memory_bytes);
  EXPECT_EQ(renderer.sampling.spp_scale, 1);
  EXPECT_EQ(renderer.format.name, "orbs-scene");
  EXPECT_EQ(configuration.defaults.suite, "orbs");
  EXPECT_TRUE(configuration.defaults.log);
}

TEST(Configuration, SeveralSeedsNeedAPlaceForThemInTheCommand) {
  const auto message = message_of(with_renderer(kRenderer + R"(, "seeds": 2)"));
  EXPECT_NE(message.find("/renderers/0/seeds: needs {seed} in the command"), std::string::npos) << message;
  EXPECT_NE(message_of(with_renderer(kRenderer + R"(, "seeds": 17)")).find("/seeds:"), std::string::npos);
  const auto fitting = load(with_renderer(
      R"("name": "a", "executable": "a", "declares": "G1", "command": ["{executable}", "{scene}", "{output}", "{seed}"], "seeds": 16)"));
  EXPECT_EQ(fitting.renderers[0].sampling.seeds, 16);
}

TEST(Configuration, WhatTakesASeedIsNotNoiseFree) {
  EXPECT_TRUE(load(with_renderer(kRenderer + R"(, "noise_free": true)")).renderers[0].sampling.is_noise_free);
  const auto message = message_of(with_renderer(
      R"("name": "a", "executable": "a", "declares": "G1", "command": ["{executable}", "{scene}", "{output}", "{seed}"], "noise_free": true)"));
  EXPECT_NE(message.find("/renderers/0/noise_free: contradicts {seed}"), std::string::npos) << message;
}

TEST(Configuration, AnImageSequenceStandsInThePlaceOfASeed) {
  const auto with = [](const std::string& words, const std::string& more) {
    return with_renderer(
        R"("name": "a", "executable": "a", "declares": "G1", "command": ["{executable}", "{scene}", "{output}")" +
        words + "]" + more);
  };
  const std::string sequence = R"(, "image_sequence": {"words": ["-cam_id", "0"], "suffix": "_cam"})";
  const auto read = load(with(R"(, "{images}")", sequence + R"(, "seeds": 2)")).renderers[0];
  EXPECT_EQ(read.command.sequence.words, (std::vector<std::string>{"-cam_id", "0"}));
  EXPECT_EQ(read.command.sequence.suffix, "_cam");
  EXPECT_TRUE(takes_seed(read.command));
  const auto problem = [&](const std::string& words, const std::string& more) {
    const auto message = message_of(with(words, more));
    return message.substr(message.find("/renderers"));
  };
  EXPECT_TRUE(problem("", sequence).starts_with("/renderers/0/image_sequence: needs {images}"));
  EXPECT_TRUE(problem(R"(, "{images}")", "").starts_with("/renderers/0/command: uses {images}"));
  EXPECT_TRUE(problem(R"(, "-n={images}")", sequence)
                  .starts_with("/renderers/0/command/3: {images} stands for words"));
  EXPECT_TRUE(
      problem(R"(, "{images}", "{seed}")", sequence).starts_with("/renderers/0/image_sequence: contradicts"));
  EXPECT_TRUE(problem(R"(, "{images}")", sequence + R"(, "noise_free": true)")
                  .starts_with("/renderers/0/noise_free:"));
}

TEST(Configuration, WordsOfFailureArePatternsThatNotEveryLineMatches) {
  const auto with = [](const std::string& patterns) {
    const auto message = message_of(with_renderer(kRenderer + R"(, "fails_on": [)" + patterns + "]"));
    return message.substr(std::min(message.size(), message.find("/renderers")));
  };
  EXPECT_EQ(load(with_renderer(kRenderer + R"(, "fails_on": ["ERROR", "not found"])"))
                .renderers[0]
                .command.fails_on,
            (std::vector<std::string>{"ERROR", "not found"}));
  EXPECT_EQ(with(R"("a", "x*")"), "/renderers/0/fails_on/1: matches an empty line, and so every output");
  EXPECT_TRUE(with(R"("(")").starts_with("/renderers/0/fails_on/0: '(' is no regular expression"));
}

TEST(Configuration, AVariantMayHaveSettingsOfItsOwn) {
  const auto renderers =
      load(with_renderer(kRenderer +
                         R"(, "scene_format": "povray", "scene_settings": {"photons": 5, "area_grid": 8},
    "variants": [{"name": "a", "arguments": []}, {"name": "b", "arguments": [], "scene_settings": {"photons": 7}}])"))
          .renderers;
  EXPECT_EQ(renderers[0].format.settings.at("photons"), 5);
  EXPECT_EQ(renderers[1].format.settings.at("photons"), 7);
  EXPECT_EQ(renderers[1].format.settings.at("area_grid"), 8);
}

TEST(Configuration, FoldersAreRelativeToTheFile) {
  const auto configuration = load(with_renderer(kRenderer));
  EXPECT_EQ(configuration.suites[0].cases, configuration.root / "c");
}

TEST(Configuration, EveryFlagHasADefaultThatMayStandInTheFile) {
  const auto text =
      R"({"format": "orbs-configuration/1", "suites": [], "renderers": [], "defaults": {"suite": "x", "case": "c*",
    "scene": "1", "requirement": "M*", "renderer": "r", "exec": "/bin/true", "output": "out", "jobs": 3, "threads": 2,
    "seed": 9, "spp_scale": 0.5, "size": "1/4", "log": false, "dry_run": true, "view": true}})";
  const auto defaults = load(text).defaults;
  EXPECT_EQ(defaults.suite, "x");
  EXPECT_EQ(defaults.cases, "c*");
  EXPECT_EQ(defaults.scenes, "1");
  EXPECT_EQ(defaults.requirements, "M*");
  EXPECT_EQ(defaults.renderers, "r");
  EXPECT_EQ(defaults.executable, "/bin/true");
  EXPECT_EQ(defaults.output, "out");
  EXPECT_EQ(defaults.jobs, 3);
  EXPECT_EQ(defaults.threads, 2);
  EXPECT_EQ(defaults.seed, 9);
  EXPECT_EQ(defaults.spp_scale, 0.5);
  EXPECT_EQ(defaults.size_divisor, 4);
  EXPECT_FALSE(defaults.log);
  EXPECT_TRUE(defaults.dry_run);
  EXPECT_TRUE(defaults.view);
}

// The seeds that follow it must be numbers of the same kind.
TEST(Configuration, TheSeedLeavesRoomForThoseThatFollow) {
  EXPECT_NE(
      message_of(
          R"({"format": "orbs-configuration/1", "suites": [], "renderers": [], "defaults": {"seed": 2147483647}})")
          .find("/defaults/seed"),
      std::string::npos);
}

// The text "false" is not empty, and must not be taken for true.
TEST(Configuration, ATextIsNoBoolean) {
  EXPECT_EQ(
      message_of(
          R"({"format": "orbs-configuration/1", "suites": [], "renderers": [], "defaults": {"log": "false"}})"),
      "configuration.json:1:87: /defaults/log: must be true or false, is string");
}

TEST(Configuration, SyntaxErrorsNameLineAndColumn) {
  EXPECT_EQ(message_of("{\n \"format\": }").substr(0, 23), "configuration.json:2:12");
}

TEST(Configuration, UnknownKeysAreErrorsWithTheNearestWord) {
  EXPECT_EQ(message_of(with_renderer(kRenderer + R"(, "version_comand": ["a"])")),
            "configuration.json:3:150: /renderers/0/version_comand: unknown key (did you mean "
            "'version_command'?)");
}

TEST(Configuration, LimitsOfARendererStandInPlaceOfThoseOfTheFile) {
  const auto configuration = load(
      R"({"format": "orbs-configuration/1", "suites": [], "limits": {"wall_seconds": 5, "memory_megabytes": 2}, "renderers": [{)" +
      kRenderer + R"(, "limits": {"wall_seconds": 7, "cpu_seconds": 3}}]})");
  const auto& limits = configuration.renderers.at(0).limits;
  EXPECT_EQ(limits.wall_seconds, 7);
  EXPECT_EQ(limits.cpu_seconds, 3);
  EXPECT_EQ(limits.memory_bytes, 2U << 20);
  EXPECT_FALSE(limits.output_bytes);
}

TEST(Configuration, SettingsOfSizesAreKnownByTheirDivisor) {
  const auto renderer = with_renderer(kRenderer + R"(, "scene_settings_of_sizes": {"1/4": {"photons": 5}})");
  EXPECT_EQ(
      load(renderer).renderers.at(0).format.settings_of_sizes.at(orbs::registry::QuarterSize).at("photons"),
      5);
  EXPECT_EQ(
      message_of(with_renderer(kRenderer + R"(, "scene_settings_of_sizes": {"1/3": {"photons": 5}})")),
      "configuration.json:3:167: /renderers/0/scene_settings_of_sizes/1~13: '1/3' is no size; there are 1, 1/2, "
      "1/4 and 1/8 of the full width");
  const auto full =
      message_of(with_renderer(kRenderer + R"(, "scene_settings_of_sizes": {"1": {"photons": 5}})"));
  EXPECT_NE(full.find("/scene_settings_of_sizes/1: is no reduced size"), std::string::npos) << full;
}

TEST(Configuration, SettingsOfAScenePrecedeThoseOfASize) {
  const auto renderer =
      load(with_renderer(kRenderer + R"(, "scene_settings": {"photons": 4, "radiosity": 1})"
                                     R"(, "scene_settings_of_sizes": {"1/4": {"photons": 5}})"
                                     R"(, "scene_settings_of_scenes": {"124": {"photons": 6}})"))
          .renderers.at(0);
  const auto photons = [&](orbs::registry::SizeDivisor size_divisor, const char* scene) {
    const auto own = orbs::registry::for_scene(orbs::registry::at_size(renderer, size_divisor), scene);
    EXPECT_EQ(own.format.settings.at("radiosity"), 1);
    return own.format.settings.at("photons");
  };
  EXPECT_EQ(photons(orbs::registry::FullSize, "101"), 4);
  EXPECT_EQ(photons(orbs::registry::QuarterSize, "101"), 5);
  EXPECT_EQ(photons(orbs::registry::QuarterSize, "124"), 6);
  EXPECT_EQ(photons(orbs::registry::FullSize, "124"), 6);
}

TEST(Configuration, ScalesOfSamplesMustBePositive) {
  EXPECT_EQ(message_of(with_renderer(kRenderer + R"(, "spp_scale": 0)")),
            "configuration.json:3:145: /renderers/0/spp_scale: must be above 0, is 0");
}

TEST(Configuration, UnknownPlaceholdersAreFoundBeforeAnythingStarts) {
  EXPECT_EQ(
      message_of(with_renderer(
          R"("name": "a", "executable": "a", "declares": "G1", "command": ["{executable}", "{scene}", "{out}", "{output}"])")),
      "configuration.json:3:106: /renderers/0/command/2: unknown placeholder {out} (did you mean "
      "'root'?); known are: aa_grid, antialiasing, arguments, bounces, build, data, effects, executable, folder, height, images, layer, output, plugin, root, scene, seed, spp, "
      "threads, trace_depth, transport, width");
}

TEST(Configuration, WordsForTransportsAreTextsThatAreNotEmpty) {
  const std::string rest =
      R"("declares": "G1", "command": ["{executable}", "{transport}", "{scene}", "{output}"])";
  const auto with = [&](const std::string& words) {
    return message_of(
        with_renderer(R"("name": "a", "executable": "a", "transports": )" + words + ", " + rest));
  };
  EXPECT_EQ(with(R"({"rgb": "scalar_rgb"})"), "no error");
  EXPECT_NE(with(R"({"rgb": ""})").find("/renderers/0/transports/rgb: must not be empty"), std::string::npos)
      << with(R"({"rgb": ""})");
  EXPECT_NE(with(R"({"rgb": 3})").find("/renderers/0/transports/rgb"), std::string::npos)
      << with(R"({"rgb": 3})");
}

TEST(Configuration, ACommandMustTellTheRendererItsSceneAndItsOutput) {
  EXPECT_NE(
      message_of(
          with_renderer(
              R"("name": "a", "executable": "a", "declares": "G1", "command": ["{executable}", "{output}"])"))
          .find("/renderers/0/command: must use {scene}"),
      std::string::npos);
  EXPECT_NE(
      message_of(
          with_renderer(
              R"("name": "a", "executable": "a", "declares": "G1", "command": ["{executable}", "{scene}"])"))
          .find("/renderers/0/command: must use {output}"),
      std::string::npos);
}

TEST(Configuration, ARenderersOwnTimeStandsInItsOutputOrInAFile) {
  const auto place = [](const std::string& members) {
    return load(with_renderer(kRenderer + R"(, "render_seconds": {)" + members + "}"))
        .renderers[0]
        .timing.render_seconds;
  };
  EXPECT_EQ(place(R"x("pattern": "([0-9]+):([0-9.]+)")x").pattern, "([0-9]+):([0-9.]+)");
  EXPECT_EQ(place(R"x("file": "a/b.json", "key": "t", "unit_seconds": 0.001)x").unit_seconds, 0.001);
  const auto problem = [](const std::string& members) {
    const auto text = message_of(with_renderer(kRenderer + R"(, "render_seconds": {)" + members + "}"));
    return text.substr(text.find("/renderers"));
  };
  EXPECT_EQ(problem(R"x("pattern": "t", "file": "f")x"),
            "/renderers/0/render_seconds: needs either 'pattern', for the renderer's output, or 'file' and "
            "'key', for a JSON file");
  EXPECT_EQ(
      problem(R"x("pattern": "took")x"),
      "/renderers/0/render_seconds/pattern: has 0 groups in parentheses, needs 1 (seconds), 2 (minutes, "
      "seconds; or a number and its unit) or 3 (hours, minutes, seconds)");
  EXPECT_TRUE(problem(R"x("pattern": "(")x")
                  .starts_with("/renderers/0/render_seconds/pattern: '(' is no regular expression: "));
  EXPECT_EQ(
      problem(R"x("file": "../t.json", "key": "t")x"),
      "/renderers/0/render_seconds/file: must lie in the folder of the render: a relative path without '..'");
}

TEST(Configuration, AVersionIsOneGroupOfAPattern) {
  const auto right = with_renderer(kRenderer + R"x(, "version_pattern": "^(r [^,]+)")x");
  EXPECT_EQ(load(right).renderers[0].command.version_pattern, "^(r [^,]+)");
  EXPECT_NE(message_of(with_renderer(kRenderer + R"x(, "version_pattern": "^r")x"))
                .find("has 0 groups in parentheses, needs 1, which holds the version"),
            std::string::npos);
}

TEST(Configuration, AStrideOfSeedsNeedsASeed) {
  EXPECT_NE(
      message_of(with_renderer(kRenderer + R"(, "seed_stride": 7)")).find("needs {seed} in the command"),
      std::string::npos);
}

TEST(Configuration, HandWrittenScenesHaveAnEnding) {
  const auto native =
      load(with_renderer(kRenderer + R"(, "scene_format": "native", "native_scenes": "arm")"));
  EXPECT_EQ(native.renderers[0].format.name, "native");
  EXPECT_EQ(native.renderers[0].format.native_scenes, "arm");
  EXPECT_NE(
      message_of(with_renderer(kRenderer + R"(, "scene_format": "native")")).find("needs 'native_scenes'"),
      std::string::npos);
  EXPECT_NE(message_of(with_renderer(kRenderer + R"(, "native_scenes": ".arm")")).find("is no ending"),
            std::string::npos);
}

TEST(Configuration, NamesGivenTwiceAreErrors) {
  const auto text = R"({"format": "orbs-configuration/1", "suites": [], "renderers": [{)" + kRenderer +
                    "},\n{" + kRenderer + "}]}";
  EXPECT_EQ(message_of(text),
            "configuration.json:2:10: /renderers/1/name: 'a' is the name of an earlier entry");
}

TEST(Configuration, NamesThatWouldLeaveTheOutputFolderAreErrors) {
  for (const char* name : {"", "..", "a/b", "a b", "a*", "a,b"})
    EXPECT_NE(message_of(with_renderer(R"("name": ")" + std::string(name) +
                                       R"(", "executable": "a", "declares": "G1", "command": [])"))
                  .find("is no name"),
              std::string::npos)
        << name;
}

TEST(Configuration, FeatureNumbersAndLimitsAreCheckedAtTheirPlace) {
  EXPECT_NE(message_of(with_renderer(R"("name": "a", "executable": "a", "declares": "G1/x", "command": [])"))
                .find("/renderers/0/declares: feature number 'x'"),
            std::string::npos);
  EXPECT_NE(message_of(with_renderer(kRenderer +
                                     R"(, "known_limits": [{"requirements": ["M3", "M2"], "reason": "r"}])"))
                .find("/renderers/0/known_limits/0/requirements/1: 'declares' has M2"),
            std::string::npos);
  EXPECT_NE(
      message_of(with_renderer(kRenderer + R"(, "known_limits": [{"requirements": ["3"], "reason": "r"}])"))
          .find("/renderers/0/known_limits/0/requirements/0: '3' is no requirement"),
      std::string::npos);
}

TEST(Configuration, AnUnknownSuiteIsAnErrorWithTheNearestName) {
  const auto configuration = load(with_renderer(kRenderer));
  try {
    orbs::registry::find_suite(configuration, "st");
    FAIL();
  } catch (const orbs::InputError& e) {
    EXPECT_NE(std::string(e.what()).find("has no suite 'st' (did you mean 's'?)"), std::string::npos)
        << e.what();
  }
}

TEST(Configuration, TheOneOfTheRepositoryIsRight) {
  const auto configuration = load_configuration(ORBS_SOURCE_DIR "/configuration.json");
  std::vector<std::string> formats;
  for (const auto& renderer : configuration.renderers) formats.push_back(renderer.format.name);
  EXPECT_EQ(formats, (std::vector<std::string>{"orbs-scene", "orbs-scene", "povray", "mitsuba", "pbrt",
                                               "hydra", "hydra", "hydra", "obj", "ply", "gltf", "gltf"}));
}

TEST(Configuration, WhatIsOnlyWhenNamedIsNoneOfAllRenderers) {
  const auto configuration = load(
      R"({"format": "orbs-configuration/1", "suites": [{"name": "s", "cases": "c", "references": "r"}], "renderers": [
    {"name": "one", "executable": "a", "declares": "G1", "command": ["{executable}", "{scene}", "{output}"]},
    {"name": "one-more", "executable": "a", "declares": "G1", "only_when_named": true,
     "command": ["{executable}", "{scene}", "{output}"], "variants": [{"name": "v", "arguments": []}]}]})");
  const auto chosen = [&](const char* list) { return orbs::registry::chosen_renderers(configuration, list); };
  using Names = std::vector<std::string>;
  EXPECT_EQ(chosen("*"), Names{"one"});
  EXPECT_EQ(chosen("*,one"), Names{"one"});
  for (const char* list : {"one-more", "one-more-v", "*-v"})
    EXPECT_EQ(chosen(list), Names{"one-more-v"}) << list;
  for (const char* list : {"one*", "*,one-more"})
    EXPECT_EQ(chosen(list), (Names{"one", "one-more-v"})) << list;
}

TEST(Configuration, IsLookedForInTheFoldersAbove) {
  const TestFolder scratch("registry-nearest");
  scratch.write("configuration.json", "{}");
  scratch.write("a/b/c.txt", "");
  EXPECT_EQ(orbs::registry::nearest_configuration(scratch.path() / "a" / "b"),
            scratch.path() / "configuration.json");
}

// Each entry keeps its line for messages: looked for from the start of the file for each of them, 2,000
// entries took 5 s.
TEST(Configuration, IsReadInStepsThatGrowWithItsLength) {
  const auto steps_a_byte = [](int entries) {
    std::string text =
        R"({"format": "orbs-configuration/1", "suites": [{"name": "s", "cases": "c", "references": "r"}],
 "renderers": [)";
    for (int i = 0; i < entries; ++i)
      text += fmt::format(R"({}
{{"name": "r{}", "executable": "a", "declares": "G1", "command": ["a", "{{scene}}", "{{output}}"]}})",
                          i == 0 ? "" : ",", i);
    text += "]}";
    const auto before = orbs::json::bytes_stepped_over();
    const auto configuration = load(text);
    EXPECT_TRUE(configuration.renderers.back().place.ends_with(fmt::format(":{}", entries + 2)));
    return static_cast<double>(orbs::json::bytes_stepped_over() - before) / static_cast<double>(text.size());
  };
  const double few = steps_a_byte(500);
  const double many = steps_a_byte(2000);
  EXPECT_LT(few, 5);
  EXPECT_LT(many, 1.05 * few);
}
