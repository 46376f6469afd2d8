// A renderer that looks for what it must not see, with --sandbox and without.
#include "cli/sandbox.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

using orbs::cli_tests::Answer;
using orbs::cli_tests::Sandbox;

namespace {

// Renders as the one that it stands for, and says in its log what it could do beside.
void write_curious_renderer(const Sandbox& sandbox) {
  sandbox.write(
      "curious",
      fmt::format("#!/bin/sh\n"
                  "cat {0}/references/*.exr ../references/*.exr ../../references/*.exr > found 2>&1\n"
                  "test -n \"$(find found -size +1k)\" && echo it reads references\n"
                  "(echo x > {0}/mark) 2> /dev/null && echo it writes elsewhere\n"
                  "grep -q 'eth\\|ens\\|enp' /proc/net/dev && echo it has a network\n"
                  "exec {1}/orbs-fake-renderer \"$@\"\n",
                  sandbox.folder().string(), ORBS_BINARY_DIR));
  ::chmod((sandbox.folder() / "curious").c_str(), 0755);
}

std::string log_of(const Sandbox& sandbox, const std::string& run) {
  return sandbox.read(run + "/good/grey/log.txt");
}

}  // namespace

TEST(Isolation, ARendererSeesNoReferencesAndWritesNowhereElse) {
  const Sandbox sandbox;
  write_curious_renderer(sandbox);
  EXPECT_EQ(sandbox.orbs({"run", "-r", "good", "-s", "grey", "-e", "./curious", "-o", "open"}).status, 0);
  EXPECT_NE(log_of(sandbox, "open").find("it reads references"), std::string::npos);
  EXPECT_NE(log_of(sandbox, "open").find("it writes elsewhere"), std::string::npos);

  const Answer answer =
      sandbox.orbs({"run", "-r", "good", "-s", "grey", "-e", "./curious", "--sandbox", "-o", "shut"});
  if (answer.text.find("bwrap says") != std::string::npos)
    GTEST_SKIP() << "the kernel or container refuses namespaces: " << answer.text;
  EXPECT_EQ(answer.status, 0) << answer.text;
  EXPECT_EQ(log_of(sandbox, "shut").find("it reads"), std::string::npos) << log_of(sandbox, "shut");
  EXPECT_EQ(log_of(sandbox, "shut").find("it writes"), std::string::npos) << log_of(sandbox, "shut");
  EXPECT_EQ(log_of(sandbox, "shut").find("it has a network"), std::string::npos) << log_of(sandbox, "shut");
}

TEST(Isolation, WithoutBubblewrapTheRunIsRefused) {
  const Sandbox sandbox;
  const Answer answer = sandbox.shell(
      fmt::format("PATH=/nowhere {}/orbs run -r good -s grey --sandbox -o out", ORBS_BINARY_DIR));
  EXPECT_EQ(answer.status, 2);
  EXPECT_NE(answer.text.find("install bubblewrap, or run without --sandbox"), std::string::npos)
      << answer.text;
  EXPECT_FALSE(sandbox.has("out"));
}
