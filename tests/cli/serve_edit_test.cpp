// `orbs serve --edit`: a click writes what `orbs run --accept-failures` writes.
#include "base/text.h"
#include "cli/sandbox.h"

#include <gtest/gtest.h>

using orbs::cli_tests::Answer;
using orbs::cli_tests::contains;
using orbs::cli_tests::Sandbox;

namespace {

const std::vector<std::string> kRun{"run", "-r", "dark", "-c", "m1_grey", "-s", "grey", "-o", "out"};

// What the page would get for accepting the failure of "dark" in the run "out".
Answer click(const Sandbox& sandbox, const std::string& reason, const std::string& until) {
  const auto program = orbs::shell_text({ORBS_BINARY_DIR "/orbs"});
  const auto client =
      orbs::shell_text({"/usr/bin/python3", ORBS_SOURCE_DIR "/tests/cli/serve_edit_client.py"});
  // An address of a server before would be taken for that of this one.
  return sandbox.shell("rm -f served; " + program +
                       " serve --edit out > served 2> served-errors & server=$!; " +
                       "for i in $(seq 200); do grep -q edit= served && break; sleep 0.05; done; " + client +
                       " \"$(grep -o 'http:[^ ]*' served)\" dark grey " + orbs::shell_text({reason, until}) +
                       "; status=$?; kill $server; wait $server; exit $status");
}

}  // namespace

TEST(ServeEdit, WritesWhatTheCommandWrites) {
  const Sandbox by_command;
  const Sandbox by_click;
  auto accepting = kRun;
  accepting.insert(accepting.end(), {"--accept-failures", "it's \"dark\""});
  EXPECT_EQ(by_command.orbs(accepting).status, 0);
  EXPECT_EQ(by_click.orbs(kRun).status, 1);
  const auto results = by_click.read("out/results.json");
  const auto answer = click(by_click, "it's \"dark\"", "");
  EXPECT_EQ(answer.status, 0) << answer.text;
  EXPECT_TRUE(contains(answer.text, "+\"expected\": [")) << answer.text;
  EXPECT_TRUE(contains(answer.text, " True")) << answer.text;
  EXPECT_EQ(by_click.read("configuration.json"), by_command.read("configuration.json"));
  EXPECT_EQ(by_click.read("out/results.json"), results) << "the run stays as it was judged";
  auto next = kRun;
  next.back() = "next";
  EXPECT_EQ(by_click.orbs(next).status, 0) << "the next run knows it";
}

TEST(ServeEdit, WritesTheLastDay) {
  const Sandbox sandbox;
  sandbox.orbs(kRun);
  ASSERT_EQ(click(sandbox, "r", "2999-12-31").status, 0);
  EXPECT_TRUE(contains(sandbox.read("configuration.json"), "\"until\": \"2999-12-31\""));
  // A later click replaces the entry, and its day if it names one.
  ASSERT_EQ(click(sandbox, "other", "").status, 0);
  EXPECT_TRUE(contains(sandbox.read("configuration.json"), "\"until\": \"2999-12-31\""));
  ASSERT_EQ(click(sandbox, "other", "2999-01-02").status, 0);
  const auto text = sandbox.read("configuration.json");
  EXPECT_TRUE(contains(text, "\"until\": \"2999-01-02\"") && contains(text, "other")) << text;
  EXPECT_FALSE(contains(text, "\"reason\": \"r\"") || contains(text, "12-31")) << text;
}

TEST(ServeEdit, BadReasonsAndDaysAreRefused) {
  const Sandbox sandbox;
  sandbox.orbs(kRun);
  const auto before = sandbox.read("configuration.json");
  struct Bad {
    const char* reason;
    const char* until;
    const char* message;
  };
  for (const auto& [reason, until, message] :
       {Bad{"", "", "the reason must say why"}, Bad{" \t", "", "the reason must say why"},
        Bad{"r", "soon", "soon"}, Bad{"r", "2999-02-30", "2999-02-30"},
        Bad{"r", "2020-01-01", "the last day, 2020-01-01, is over"}}) {
    const auto answer = click(sandbox, reason, until);
    EXPECT_EQ(answer.status, 1) << reason << until;
    EXPECT_TRUE(contains(answer.text, "422 ") && contains(answer.text, message)) << answer.text;
  }
  EXPECT_EQ(sandbox.read("configuration.json"), before);
}

TEST(ServeEdit, IsRefusedWhereOthersReachThePageOrReadItsAddress) {
  const Sandbox sandbox;
  for (const auto& words :
       std::vector<std::vector<std::string>>{{"serve", "--edit", "--allow-network"},
                                             {"serve", "--edit", "--address", "0.0.0.0"},
                                             {"serve", "--edit", "--address", "0.0.0.0", "--allow-network"},
                                             {"serve", "--edit", "--open"}}) {
    const auto answer = sandbox.orbs(words);
    EXPECT_EQ(answer.status, 2) << answer.text;
    EXPECT_TRUE(contains(answer.text, "--edit")) << answer.text;
  }
}
