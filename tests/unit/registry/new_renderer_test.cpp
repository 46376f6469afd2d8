#include "registry/new_renderer.h"

#include "base/error.h"
#include "base/files.h"
#include "structure/source_files.h"

#include <gtest/gtest.h>

using namespace orbs;
using registry::add_renderer;
using structure::TestFolder;

namespace {

// Comments cannot stand in JSON, but blanks and the order of keys are its writer's.
const std::string kText = R"({ "format":   "orbs-configuration/1",
  "renderers": [
    { "name": "a",  "executable": "a", "declares": "G1", "scene_format": "pbrt",
      "command": ["{executable}", "{scene}", "--outfile", "{output}"] }
  ],
  "suites": [ {"name": "s", "cases": "c", "references": "r"} ]   }
)";

struct Stand {
  Stand() { folder.write("configuration.json", kText); }
  registry::Configuration read() const { return registry::load_configuration(file()); }
  std::filesystem::path file() const { return folder.path() / "configuration.json"; }
  TestFolder folder{"new-renderer"};
};

std::string message_of(const Stand& stand, const registry::NewRenderer& added) {
  try {
    add_renderer(stand.read(), added);
  } catch (const InputError& e) {
    return e.what();
  }
  return "no error";
}

}  // namespace

TEST(NewRenderer, IsReadBackAndEveryOtherByteStays) {
  const Stand stand;
  const auto added = add_renderer(stand.read(), {.name = "mine", .executable = "/opt/my renderer"});
  EXPECT_EQ(added.command.executable, "/opt/my renderer");
  const auto text = read_file(stand.file());
  const auto end_of_first = kText.find("\"{output}\"] }") + 13;
  EXPECT_EQ(text.substr(0, end_of_first), kText.substr(0, end_of_first));
  const auto rest = kText.substr(end_of_first);
  EXPECT_TRUE(text.ends_with("}" + rest)) << text;
  const auto read = stand.read();
  ASSERT_EQ(read.renderers.size(), 2U);
  EXPECT_EQ(read.renderers[1].name, "mine");
  EXPECT_EQ(read.renderers[1].command.words.front(), "{executable}");
}

TEST(NewRenderer, OfAFormatTakesTheCommandOfTheFirstWithThatFormat) {
  const Stand stand;
  const auto added = add_renderer(stand.read(), {.name = "b", .scene_format = "pbrt"});
  EXPECT_EQ(added.command.words, stand.read().renderers[0].command.words);
  EXPECT_EQ(added.command.executable, "b");
}

TEST(NewRenderer, TakesTheWordsForTransportsAlongWithTheCommand) {
  const Stand stand;
  stand.folder.write("configuration.json", R"({ "format": "orbs-configuration/1", "suites": [], "renderers": [
    { "name": "a", "executable": "a", "declares": "G1", "scene_format": "mitsuba",
      "transports": { "rgb": "scalar_rgb" }, "command": ["{executable}", "{transport}", "{scene}", "{output}"] } ] })");
  const auto added = add_renderer(stand.read(), {.name = "b", .scene_format = "mitsuba"});
  EXPECT_EQ(added.format.transports, stand.read().renderers[0].format.transports);
  const auto other = add_renderer(stand.read(), {.name = "c", .scene_format = "povray"});
  EXPECT_TRUE(other.format.transports.empty());
}

TEST(NewRenderer, WithATakenNameOrAWrongEntryLeavesTheFileAlone) {
  const Stand stand;
  EXPECT_NE(message_of(stand, {.name = "a"}).find("has a renderer 'a' already"), std::string::npos);
  EXPECT_NE(message_of(stand, {.name = "b c"}).find("'b c' is no name"), std::string::npos);
  const auto message = message_of(stand, {.name = "b", .command = {"{executable}", "{scene}"}});
  EXPECT_NE(message.find("must use {output}"), std::string::npos) << message;
  EXPECT_NE(message.find("while adding renderer 'b'"), std::string::npos) << message;
  EXPECT_NE(message_of(stand, {.name = "b", .scene_format = "native"}).find("needs 'native_scenes'"),
            std::string::npos);
  EXPECT_EQ(read_file(stand.file()), kText);
}
