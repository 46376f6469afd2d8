// The shipped configuration is that of the checkout; the user's own lie in the sandbox.
#include "cli/sandbox.h"

#include <cstdlib>
#include <filesystem>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace fs = std::filesystem;
using namespace orbs::cli_tests;

namespace {

constexpr const char* kMine =
    R"("renderers": [{"name": "mine", "executable": "{root}/mine.sh", "declares": "G1", "command": ["{executable}", "{scene}", "{output}"]},
 {"name": "orbs", "spp_scale": 3}])";

// `members` as a file of one's own over the shipped one.
std::string own(const std::string& members) {
  return "{\"format\": \"orbs-configuration/1\",\n" + members + "}\n";
}

// The sandbox without its file, which stands alone: what is run in it has its folders for user and system.
struct Stand {
  Stand() {
    fs::remove(sandbox.folder() / "configuration.json");
    environment =
        fmt::format("XDG_CONFIG_HOME={0}/user ORBS_SYSTEM_FOLDER={0}/system ", sandbox.folder().string());
  }
  Answer orbs(const std::string& arguments) const {
    return sandbox.shell(environment + ORBS_BINARY_WORD "/orbs " + arguments);
  }
  Sandbox sandbox;
  std::string environment;
};

}  // namespace

TEST(ConfigurationLayers, TestsDoNotReadTheFilesOfWhoeverRunsThem) {
  for (const char* variable : {"XDG_CONFIG_HOME", "ORBS_SYSTEM_FOLDER"}) {
    const char* folder = std::getenv(variable);
    ASSERT_NE(folder, nullptr) << variable;
    EXPECT_TRUE(std::string(folder).starts_with(ORBS_BINARY_DIR)) << folder;
    EXPECT_FALSE(fs::exists(folder)) << folder;
  }
}

TEST(ConfigurationLayers, EachFileChangesWhatLiesBelowIt) {
  const Stand stand;
  stand.sandbox.write("system/configuration.json", own(R"("defaults": {"jobs": 7, "threads": 5})"));
  stand.sandbox.write("user/orbs/configuration.json", own(R"("defaults": {"jobs": 6})"));
  stand.sandbox.write("configuration.json", own(kMine));
  const auto answer = stand.orbs("doctor -r '*'");
  EXPECT_EQ(answer.status, 0) << answer.text;
  const auto folder = stand.sandbox.folder().string();
  for (const auto& part : {fmt::format("configuration  {}/configuration.json", folder),
                           fmt::format("defaults/jobs  {}/user/orbs/configuration.json:2", folder),
                           fmt::format("defaults/threads  {}/system/configuration.json:2", folder),
                           fmt::format("spp_scale in {}/configuration.json:3", folder),
                           fmt::format("not installed: '{}/mine.sh' was not found", folder)})
    EXPECT_TRUE(contains(answer.text, part)) << part << "\n" << answer.text;
  EXPECT_LT(answer.text.find("mine\n  program"), answer.text.find("configuration  "))
      << "what was asked comes first";
  // Of the values those that somebody has changed.
  const auto overview = stand.orbs("doctor").text;
  for (const auto& text : {answer.text, overview}) {
    EXPECT_TRUE(contains(text, "defaults/jobs  ")) << text;
    EXPECT_FALSE(contains(text, "defaults/suite  ")) << text;
  }
}

TEST(ConfigurationLayers, ARendererIsAddedToTheUsersFile) {
  const Stand stand;
  const auto answer = stand.orbs("renderer add mine --executable /bin/true");
  EXPECT_EQ(answer.status, 0) << answer.text;
  EXPECT_TRUE(contains(
      answer.text, fmt::format("added to {}/user/orbs/configuration.json", stand.sandbox.folder().string())))
      << answer.text;
  const auto list = stand.orbs("list renderers");
  EXPECT_TRUE(contains(list.text, "mine")) << list.text;
  EXPECT_TRUE(contains(list.text, "cycles")) << list.text;
  // The nearest file is one's own, too.
  stand.sandbox.write("configuration.json", own(R"("defaults": {})"));
  EXPECT_EQ(stand.orbs("renderer add other --executable /bin/true").status, 0);
  EXPECT_TRUE(contains(stand.sandbox.read("configuration.json"), "other"));
  stand.sandbox.write("named.json", own(R"("defaults": {})"));
  const auto named = stand.orbs("renderer add third --executable /bin/true --configuration named.json");
  EXPECT_EQ(named.status, 0) << named.text;
  EXPECT_TRUE(contains(stand.sandbox.read("named.json"), "third"));
}

TEST(ConfigurationLayers, FailuresAreAcceptedIntoTheUsersFile) {
  const Stand stand;
  stand.sandbox.write(
      "user/orbs/configuration.json",
      own(R"("renderers": [{"name": "dark", "executable": "{build}/orbs-fake-renderer", "declares": "G5/M8/L4/A4",
 "command": ["{executable}", "--mode", "dark", "--output", "{output}", "--scene", "{scene}", "--width", "{width}", "--height", "{height}", "--grey", "0.2",
             "--threads", "{threads}", "--spp", "{spp}", "--seed", "{seed}"]}])"));
  const auto run = stand.orbs("run -r dark -s 101 --size 1/8 -o out --accept-failures 'it is dark'");
  EXPECT_EQ(run.status, 0) << run.text;
  const auto file = stand.sandbox.folder().string() + "/user/orbs/configuration.json";
  EXPECT_TRUE(contains(run.text, "configuration: " + file)) << run.text;
  EXPECT_TRUE(contains(run.text, "  over " ORBS_SOURCE_DIR "/configuration.json")) << run.text;
  EXPECT_TRUE(contains(run.text, "known failures written to " + file) ||
              contains(run.text, "known failure written to " + file))
      << run.text;
  EXPECT_TRUE(contains(stand.sandbox.read("user/orbs/configuration.json"), "it is dark"));
  const auto again = stand.orbs("run --resume out");
  EXPECT_EQ(again.status, 0) << again.text;
}

TEST(ConfigurationLayers, AMistakeNamesTheFileAndTheLine) {
  const Stand stand;
  stand.sandbox.write("user/orbs/configuration.json",
                      own("\"renderers\": [\n{\"name\": \"cycle\", \"seeds\": 2}]"));
  const auto answer = stand.orbs("list");
  EXPECT_EQ(answer.status, 2);
  EXPECT_TRUE(contains(answer.text,
                       "user/orbs/configuration.json:3:10: /renderers/0/name: there is no renderer "
                       "'cycle' to change (did you mean 'cycles'?)"))
      << answer.text;
}

TEST(ConfigurationLayers, ACopyOfTheShippedFileFindsTheCases) {
  const Stand stand;
  const auto shipped =
      stand.sandbox.shell("sed 's|\"defaults\"|\"stands_alone\": true, \"defaults\"|' " ORBS_SOURCE_WORD
                          "/configuration.json > configuration.json");
  ASSERT_EQ(shipped.status, 0) << shipped.text;
  const auto answer = stand.orbs("run -r orbs,cycles -s 101 --size 1/8 --dry-run");
  EXPECT_EQ(answer.status, 0) << answer.text;
  EXPECT_TRUE(contains(answer.text, ORBS_SOURCE_DIR "/data/cases/orbs/") ||
              contains(answer.text, "orbs-tracer"))
      << answer.text;
  EXPECT_FALSE(contains(answer.text, stand.sandbox.folder().string() + "/adapters")) << answer.text;
}
