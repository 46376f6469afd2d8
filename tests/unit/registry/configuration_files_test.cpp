#include "registry/configuration_files.h"

#include "base/error.h"
#include "base/files.h"
#include "registry/configuration.h"
#include "registry/new_renderer.h"
#include "structure/source_files.h"

#include <functional>

#include <gtest/gtest.h>

using namespace orbs;
using structure::TestFolder;

namespace {

// Two folders: what is shipped, and what is the user's own.
struct Stand {
  Stand() {
    std::filesystem::create_directories(folder.path() / "shipped");
    std::filesystem::create_directories(folder.path() / "own");
    folder.write("shipped/configuration.json", R"({"format": "orbs-configuration/1",
  "defaults": {"suite": "s", "jobs": 2},
  "suites": [{"name": "s", "cases": "data/cases/s", "references": "data/references/s"}],
  "renderers": [
    {"name": "a", "executable": "a", "declares": "G1", "spp_scale": 2, "transports": {"rgb": "1", "spectral": "2"},
     "limits": {"wall_seconds": 9}, "plugins": ["p.so"],
     "command": ["{executable}", "{root}/a.py", "{plugin}", "{scene}", "{output}", "{data}/x", "{data}/../c.py"]}],
  "expected": [{"renderer": "a", "scene": "1", "verdict": "fail", "reason": "r"}]})");
  }
  void own(const std::string& members) const {
    folder.write("own/configuration.json", "{\"format\": \"orbs-configuration/1\",\n" + members + "}");
  }
  std::filesystem::path path(const std::string& file) const { return folder.path() / file; }
  registry::ConfigurationFiles files() const {
    return {{path("shipped/configuration.json"), path("own/configuration.json")}, path("shipped/data")};
  }
  registry::Configuration read() const { return registry::load_configuration(files()); }
  TestFolder folder{"configuration-files"};
};

std::string message_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const InputError& e) {
    return e.what();
  }
  return "no error";
}

}  // namespace

TEST(ConfigurationFiles, OneOverAnotherChangesSingleKeys) {
  const Stand stand;
  stand.own(R"("defaults": {"jobs": 3}, "renderers": [{"name": "a", "transports": {"spectral": "3"},
 "limits": {"memory_megabytes": 2}}], "limits": {"log_megabytes": 4},
 "expected": [{"renderer": "a", "scene": "2", "verdict": "fail", "reason": "q"}])");
  const auto read = stand.read();
  EXPECT_EQ(read.defaults.jobs, 3);
  EXPECT_EQ(read.defaults.suite, "s");
  ASSERT_EQ(read.renderers.size(), 1U);
  const auto& renderer = read.renderers[0];
  EXPECT_EQ(renderer.sampling.spp_scale, 2);
  EXPECT_EQ(renderer.format.transports,
            (std::map<std::string, std::string>{{"rgb", "1"}, {"spectral", "3"}}));
  EXPECT_EQ(renderer.limits.wall_seconds, 9);
  EXPECT_EQ(renderer.limits.memory_bytes, std::size_t{2} << 20);
  EXPECT_EQ(renderer.limits.log_bytes, std::size_t{4} << 20);
  ASSERT_EQ(read.expected.size(), 2U);
  EXPECT_EQ(read.expected[1].reason, "q");
  EXPECT_EQ(read.file, stand.path("own/configuration.json"));
  EXPECT_EQ(read.root, stand.path("shipped"));
}

TEST(ConfigurationFiles, PathsAndPlaceholdersAreThoseOfTheFileTheyStandIn) {
  const Stand stand;
  stand.own(R"("suites": [{"name": "t", "cases": "cases", "references": "{data}/references/t"}],
 "renderers": [{"name": "b", "executable": "{root}/b", "declares": "G1", "plugins": ["q.so", "{build}/r.so"],
   "command": ["{executable}", "{root}/b.py", "{{root}}", "{plugin}", "{scene}", "{output}", "{data}/y"]}])");
  const auto read = stand.read();
  const auto own = stand.path("own").string();
  EXPECT_EQ(read.suites[0].cases, stand.path("shipped/data/cases/s"));
  EXPECT_EQ(read.suites[1].cases, stand.path("own/cases"));
  EXPECT_EQ(read.suites[1].references, stand.path("shipped/data/references/t"));
  EXPECT_EQ(read.renderers[0].command.words[1], "{root}/a.py");
  EXPECT_EQ(read.renderers[0].command.words[5], "{root}/data/x");
  EXPECT_EQ(read.renderers[0].command.words[6], "{root}/c.py");
  const auto& command = read.renderers[1].command;
  EXPECT_EQ(command.executable, own + "/b");
  EXPECT_EQ(command.words[1], own + "/b.py");
  EXPECT_EQ(command.words[2], "{{root}}");
  EXPECT_EQ(command.words[6], "{root}/data/y");
  EXPECT_EQ(command.plugins, (std::vector<std::string>{own + "/q.so", "{build}/r.so"}));
}

TEST(ConfigurationFiles, ACopyThatStandsAloneFindsTheShippedData) {
  const Stand stand;
  stand.own(R"("stands_alone": true, "suites": [{"name": "s", "cases": "{data}/cases/s", "references": "r"}],
 "renderers": [{"name": "b", "executable": "b", "declares": "G1", "command": ["b", "{scene}", "{output}", "{data}/y"]}])");
  const auto read = stand.read();
  EXPECT_EQ(read.root, stand.path("own"));
  ASSERT_EQ(read.renderers.size(), 1U);
  EXPECT_EQ(read.suites[0].cases, stand.path("shipped/data/cases/s"));
  EXPECT_EQ(read.renderers[0].command.words[3], stand.path("shipped/data/y").string());
  EXPECT_TRUE(read.below.empty());
  stand.folder.write("shipped/configuration.json", "broken");
  EXPECT_EQ(stand.read().renderers.size(), 1U);
}

TEST(ConfigurationFiles, IncludedFilesLieBelowTheOneThatNamesThem) {
  const Stand stand;
  stand.own(
      R"("include": ["more.json", "{data}/../other.json"], "renderers": [{"name": "a", "spp_scale": 7}])");
  stand.folder.write("own/more.json", R"({"format": "orbs-configuration/1",
 "renderers": [{"name": "a", "spp_scale": 5, "seeds": 1}, {"name": "c", "executable": "c", "declares": "G1", "command": ["c", "{root}", "{scene}", "{output}"]}]})");
  stand.folder.write("shipped/other.json", R"({"format": "orbs-configuration/1", "defaults": {"jobs": 6}})");
  const auto read = stand.read();
  EXPECT_EQ(read.renderers[0].sampling.spp_scale, 7);
  EXPECT_EQ(read.renderers[1].command.words[1], stand.path("own").string());
  EXPECT_EQ(read.defaults.jobs, 6);
  EXPECT_EQ(read.below, (std::vector<std::filesystem::path>{stand.path("shipped/configuration.json"),
                                                            stand.path("own/more.json"),
                                                            stand.path("shipped/other.json")}));
}

TEST(ConfigurationFiles, MistakesNameTheFileAndTheLineTheyStandIn) {
  const Stand stand;
  const auto complains = [&](const std::string& members, const std::string& expected) {
    stand.own(members);
    const auto message = message_of([&] { stand.read(); });
    EXPECT_NE(message.find(expected), std::string::npos) << members << "\n" << message;
  };
  complains("\"renderers\": [\n{\"name\": \"a\",\n\"spp_scale\": \"2\"}]",
            "own/configuration.json:4:14: /renderers/0/spp_scale: must be a number");
  complains(
      "\"renderers\": [\n{\"name\": \"aa\",\n\"spp_scale\": 2}]",
      "own/configuration.json:3:10: /renderers/0/name: there is no renderer 'aa' to change (did you mean 'a'?)");
  complains("\"renderers\": [{\"name\": \"a\"},\n{\"name\": \"a\"}]",
            "own/configuration.json:3:10: /renderers/1/name: 'a' is the name of an earlier entry");
  complains("\"defaults\": {\"job\": 2}", "own/configuration.json:2:21: /defaults/job: unknown key");
  complains("\"include\": [\n\"none.json\"]", "own/configuration.json:3:1: /include/0: there is no file");
  complains("\"include\": [\"configuration.json\"]", "/include/0: a file cannot include itself");
  complains("\"renderers\": [{\"name\": \"a\", \"executable\": null}]",
            "shipped/configuration.json:5:5: /renderers/0: key 'executable' is missing");
  complains("\"renderers\": [{\"name\": \"a\", \"seeds\": null}]",
            "own/configuration.json:2:38: /renderers/0/seeds: must be a number");
}

TEST(ConfigurationFiles, EachValueHasThePlaceItComesFrom) {
  const Stand stand;
  stand.own("\"defaults\": {\"jobs\": 3}, \"renderers\": [\n{\"name\": \"a\", \"spp_scale\": 5}]");
  std::map<std::string, std::string> places;
  for (const auto& [value, place] : registry::value_places(stand.files())) places[value] = place;
  EXPECT_EQ(places["defaults/jobs"], stand.path("own/configuration.json").string() + ":2");
  EXPECT_EQ(places["defaults/suite"], stand.path("shipped/configuration.json").string() + ":2");
  EXPECT_EQ(places["renderers/a/spp_scale"], stand.path("own/configuration.json").string() + ":3");
  EXPECT_EQ(places["renderers/a/declares"], stand.path("shipped/configuration.json").string() + ":5");
}

TEST(ConfigurationFiles, ARendererIsAddedToOnesOwnFileWhichIsMade) {
  const Stand stand;
  const auto shipped = read_file(stand.path("shipped/configuration.json"));
  auto configuration = registry::load_configuration(
      registry::ConfigurationFiles{{stand.path("shipped/configuration.json")}, {}});
  configuration.own_file = stand.path("home/orbs/configuration.json");
  EXPECT_EQ(registry::add_renderer(configuration, {.name = "mine"}).name, "mine");
  EXPECT_EQ(read_file(stand.path("shipped/configuration.json")), shipped);
  const auto read =
      registry::load_configuration(registry::with_own(configuration.files, configuration.own_file));
  ASSERT_EQ(read.renderers.size(), 2U);
  EXPECT_EQ(read.renderers[1].name, "mine");
  configuration.own_file.clear();
  EXPECT_NE(
      message_of([&] { registry::add_renderer(configuration, {.name = "other"}); }).find("HOME is not set"),
      std::string::npos);
}
