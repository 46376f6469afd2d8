// The example of a renderer that orbs knows by configuration and a converter alone.
#include "adapters/process/programs.h"
#include "cli/sandbox.h"

#include <string>

#include <gtest/gtest.h>

using orbs::cli_tests::Answer;
using orbs::cli_tests::contains;
using orbs::cli_tests::Sandbox;

namespace {

const std::string kExample = ORBS_SOURCE_DIR "/examples/embree-pathtracer/";

class EmbreeExample : public testing::Test {
 protected:
  Answer run(const std::string& suite, const std::string& scenes, const std::string& size) const {
    return sandbox_.orbs({"run", "--configuration", kExample + "configuration.json", "-r", "embree",
                          "--suite", suite, "-s", scenes, "--size", size, "-o", "out-" + suite});
  }
  Sandbox sandbox_;
};

}  // namespace

// Of each kind that it declares, what takes seconds.
TEST_F(EmbreeExample, WhatItDeclaresPasses) {
  if (!orbs::adapters::find_program("pathtracer"))
    GTEST_SKIP() << "there is no pathtracer: the package embree-tools is not installed";
  const auto known = run("known", "furnace-plane,mirror-ball", "1");
  EXPECT_EQ(known.status, 0) << known.text;
  const auto orbs = run("orbs", "g2-camera-wide", "1/8");
  EXPECT_EQ(orbs.status, 0) << orbs.text;
  EXPECT_TRUE(contains(orbs.text, " 1 pass ")) << orbs.text;
}

// Without the program, too.
TEST_F(EmbreeExample, RefusesWhatItDoesNotKnow) {
  if (sandbox_.shell("/usr/bin/python3 -c 'import numpy'").status != 0)
    GTEST_SKIP() << "Debian's python3 has no numpy: the package python3-numpy is not installed";
  const auto exported = sandbox_.orbs({"export", "--configuration", kExample + "configuration.json", "-r",
                                       "embree", "--suite", "known", "-s", "furnace-plane", "-o", "out"});
  ASSERT_EQ(exported.status, 0) << exported.text;
  const auto convert = [&](const std::string& change) {
    return sandbox_.shell(
        "cd out/embree/furnace-plane && sed '" + change +
        "' scene.json > changed.json && /usr/bin/python3 " ORBS_SOURCE_WORD
        "/examples/embree-pathtracer/embree_pathtracer.py changed.json a.exr --program false --spp 1 --threads 1");
  };
  EXPECT_TRUE(
      contains(convert("s/\"lambert\"/\"glass\"/").text, "a material of the type glass is not known here"));
  EXPECT_TRUE(
      contains(convert("s/\"reflectance\"/\"colour\"/").text, "a material has 'colour', which is not known"));
  EXPECT_TRUE(
      contains(convert("s/\"look_at\"/\"lens\": 1, &/").text, "the camera has 'lens', which is not known"));
  EXPECT_TRUE(
      contains(convert("s/\"lights\": \\[\\]/\"lights\": [{}]/").text, "path tracing without lamps alone"));
}

TEST_F(EmbreeExample, ALampIsUnsupported) {
  const auto exported = sandbox_.orbs({"export", "--configuration", kExample + "configuration.json", "-r",
                                       "embree", "-s", "101", "-o", "out"});
  EXPECT_EQ(exported.status, 0) << exported.text;
  EXPECT_TRUE(contains(exported.text, "left out: embree 101: light")) << exported.text;
}
