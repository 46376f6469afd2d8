// Files of strangers: their texts on the terminal, and the files that their scenes name.
#include "cli/sandbox.h"

#include <filesystem>

#include <gtest/gtest.h>

using orbs::cli_tests::contains;
using orbs::cli_tests::replace_in;
using orbs::cli_tests::Sandbox;

namespace {

// Names this file as a texture of the scene "grey".
void add_texture(const Sandbox& sandbox, const std::string& file) {
  replace_in(sandbox, "cases/m1_grey/grey.json", R"("materials")",
             R"("textures": [{"name": "t", "file": ")" + file + R"("}], "materials")");
}

}  // namespace

TEST(Strangers, NoTextOfAFileReachesTheTerminalAsControl) {
  const Sandbox sandbox;
  replace_in(sandbox, "cases/m1_grey/case.json", "\"Grey\"", R"("Grey\u001b]0;x\u0007\u001b[2J\r\u202e")");
  sandbox.add_to_good(R"(, "known_limits": [{"requirements": ["L1"], "reason": "a\u001b[8mb\rc"}])");
  for (const auto& arguments : std::vector<std::vector<std::string>>{{"list"},
                                                                     {"doctor"},
                                                                     {"run", "-r", "good", "-s", "grey"},
                                                                     {"run", "--dry-run", "-r", "good"},
                                                                     {"effects"}}) {
    const auto answer = sandbox.orbs(arguments);
    EXPECT_NE(answer.status, 2) << answer.text;
    for (const char* control : {"\x1b", "\x07", "\r", "\u202e"})
      EXPECT_FALSE(contains(answer.text, control)) << arguments.front() << ": " << answer.text;
  }
}

TEST(Strangers, AFileThatASceneNamesMustLieInTheFoldersOfTheSuite) {
  const Sandbox sandbox;
  add_texture(sandbox, "/etc/hostname");
  const auto outside = sandbox.orbs({"run", "-r", "good", "--dry-run"});
  EXPECT_EQ(outside.status, 2);
  EXPECT_TRUE(contains(outside.text, "grey.json:")) << outside.text;
  EXPECT_TRUE(contains(outside.text, "leads to /etc/hostname, outside of the folders")) << outside.text;
}

TEST(Strangers, ALinkLeadsASceneNoFurtherThanAPath) {
  const Sandbox sandbox;
  sandbox.write("pictures/t.png", "no image, but nobody decodes it here");
  std::filesystem::create_symlink("../../pictures/t.png", sandbox.folder() / "cases/m1_grey/t.png");
  add_texture(sandbox, "t.png");
  const auto answer = sandbox.orbs({"run", "-r", "good", "--dry-run"});
  EXPECT_EQ(answer.status, 2);
  EXPECT_TRUE(contains(answer.text, "pictures/t.png, outside of the folders")) << answer.text;
  replace_in(sandbox, "configuration.json", R"("cases": "cases")",
             R"("cases": "cases", "data": ["pictures"])");
  const auto allowed = sandbox.orbs({"run", "-r", "good", "--dry-run"});
  EXPECT_EQ(allowed.status, 0) << allowed.text;
}

TEST(Strangers, AFolderThatCannotBeLookedIntoIsNoRunAndNoInternalError) {
  const Sandbox sandbox;
  std::filesystem::create_symlink("outputs-loop", sandbox.folder() / "outputs-loop");
  for (const char* command : {"history", "report", "serve"}) {
    std::vector<std::string> words{command};
    if (words.front() == "report") words.insert(words.end(), {"-o", "page.html"});
    const auto answer = sandbox.orbs(words);
    EXPECT_EQ(answer.status, 2) << answer.text;
    EXPECT_TRUE(contains(answer.text, "there is no outputs-* folder")) << answer.text;
  }
}

TEST(Strangers, NamesThatTheSystemRefusesAreRefusedAndNoInternalError) {
  const Sandbox sandbox;
  const std::string long_name(300, 'n');
  for (const auto& arguments :
       std::vector<std::vector<std::string>>{{"cost", "--show", long_name},
                                             {"stability", "--show", long_name},
                                             {"serve", long_name},
                                             {"merge", long_name},
                                             {"merge", ""},
                                             {"judge", ""},
                                             {"judge", long_name},
                                             {"run", "--resume", long_name},
                                             {"compare-runs", long_name, ""},
                                             {"run", "-r", "good", "-o", long_name},
                                             {"report", long_name, "-o", "x.html"},
                                             {"run", "-e", long_name, "-r", "good"},
                                             {"list", "--configuration", long_name}}) {
    const auto answer = sandbox.orbs(arguments);
    EXPECT_EQ(answer.status, 2) << arguments.front() << ": " << answer.text;
    EXPECT_FALSE(contains(answer.text, "internal error")) << answer.text;
  }
  const auto gone = sandbox.shell("mkdir gone && cd gone && rmdir ../gone && " ORBS_BINARY_WORD "/orbs list");
  EXPECT_EQ(gone.status, 2) << gone.text;
}

TEST(Strangers, ACameraOfBillionsOfPixelsIsAPlainError) {
  const Sandbox sandbox;
  replace_in(sandbox, "cases/m1_grey/grey.json", R"("width": 12, "height": 8)",
             R"("fov_y": 90, "width": 65536, "height": 65536)");
  const auto answer = sandbox.orbs({"run", "-r", "good"});
  EXPECT_EQ(answer.status, 2);
  EXPECT_TRUE(contains(answer.text, "65536 x 65536 are 4294967296 pixels; an image may have at most"))
      << answer.text;
}
