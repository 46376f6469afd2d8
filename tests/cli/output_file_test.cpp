// Where the numbers cannot go is said before minutes of rendering, not after them.
#include "cli/sandbox.h"

#include <gtest/gtest.h>

using namespace orbs;
using cli_tests::Sandbox;

namespace {

// Small work, for the case that it is done.
const std::vector<std::vector<std::string>> kCommands{
    {"probe", "-r", "orbs", "-s", "078-remap", "--side", "16", "--spp", "1"},
    {"bench", "--only", "orbs", "--side", "16", "--spp", "2", "--rounds", "1"},
    {"effect-cost", "iridescent_spheres_film", "--suite", "appearance", "--side", "16", "--spp", "8"},
    {"qualify", "control", "-r", "orbs", "-s", "078-remap"}};

// The message for the output `file`, "" for a command that has begun to work.
std::string refusal_of(const Sandbox& sandbox, std::vector<std::string> words, const std::string& file) {
  for (const char* word : {"--configuration", ORBS_SOURCE_DIR "/configuration.json", "-o"})
    words.emplace_back(word);
  words.push_back(file);
  const auto answer = sandbox.orbs(words);
  EXPECT_EQ(answer.status, 2) << words[0] << ": " << answer.text;
  return answer.text;
}

}  // namespace

TEST(OutputFile, ThatIsAFolderOrHasNoneIsRefusedAtTheStart) {
  const Sandbox sandbox;
  std::filesystem::create_directories(sandbox.folder() / "taken");
  sandbox.write("file", "");
  for (const auto& command : kCommands) {
    EXPECT_EQ(refusal_of(sandbox, command, "taken"), "orbs: taken is a folder, expected a file\n")
        << command[0];
    EXPECT_EQ(refusal_of(sandbox, command, "none/out.json"),
              "orbs: none/out.json: there is no folder none; make it, or name another file\n")
        << command[0];
    EXPECT_EQ(refusal_of(sandbox, command, "file/out.json"),
              "orbs: file/out.json: there is no folder file; make it, or name another file\n")
        << command[0];
    // Root may write everywhere but here.
    EXPECT_TRUE(refusal_of(sandbox, command, "/proc/out.json")
                    .starts_with("orbs: /proc/out.json: cannot be written: "))
        << command[0];
  }
}

TEST(OutputFile, OfAnEarlierCallStaysWhenTheNextOneFails) {
  const Sandbox sandbox;
  sandbox.write("bench.json", "old");
  EXPECT_EQ(sandbox.orbs({"bench", "--only", "absent"}).status, 2);
  EXPECT_EQ(sandbox.read("bench.json"), "old");
  for (const auto& entry : std::filesystem::directory_iterator(sandbox.folder()))
    EXPECT_NE(entry.path().extension(), ".part") << entry.path();
}
