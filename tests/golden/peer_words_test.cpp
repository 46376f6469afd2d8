/// Every file that is exported for pbrt-v4, Mitsuba 3 and HydraCore3 has only words that these programs know.
/// None is a Debian package, so the words stand in tables that were taken from their sources.
#include "golden/peer_words.h"

#include "adapters/export.h"
#include "base/files.h"
#include "registry/cases.h"
#include "registry/configuration.h"
#include "registry/renderer_variants.h"
#include "scene/load/load_scene.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

namespace {

using namespace orbs;
namespace fs = std::filesystem;

struct Peer {
  std::string name;
  std::set<std::string> (*words)(const std::string&);
};

std::map<std::string, std::string> known(const Peer& peer) {
  return tests::known_words(read_file(fs::path(ORBS_SOURCE_DIR) / "tests/data" / (peer.name + "_words.txt")));
}

registry::Renderer entry(const registry::Configuration& configuration, const std::string& name) {
  return *std::find_if(configuration.renderers.begin(), configuration.renderers.end(),
                       [&](const auto& renderer) { return registry::entry_of(renderer) == name; });
}

class PeerWords : public testing::TestWithParam<Peer> {
 protected:
  const registry::Configuration configuration_ =
      registry::load_configuration(fs::path(ORBS_SOURCE_DIR) / "configuration.json");
  const registry::Renderer renderer_ = entry(configuration_, GetParam().name);
  const ScratchFolder scratch_{"orbs-peer-words"};
  const std::map<std::string, std::string> known_ = known(GetParam());
};

INSTANTIATE_TEST_SUITE_P(Programs,
                         PeerWords,
                         testing::Values(Peer{"pbrt", tests::pbrt_words},
                                         Peer{"mitsuba", tests::mitsuba_words},
                                         Peer{"hydra", tests::hydra_words}),
                         [](const auto& peer) { return peer.param.name; });

TEST_P(PeerWords, OfEveryExportedSceneAreThoseOfTheProgram) {
  const fs::path file = scratch_.path() / adapters::scene_file_name(renderer_.format.name);
  std::set<std::string> unknown;
  int exported = 0;
  for (const auto& suite : configuration_.suites)
    for (const auto& one_case : registry::load_cases(suite))
      for (const auto& scene : one_case.scenes) {
        const auto prepared =
            adapters::prepare_scene(renderer_, scene::load_scene(scene.file, {}, scene.camera));
        if (std::holds_alternative<std::string>(prepared)) continue;
        ++exported;
        adapters::export_scene(renderer_, std::get<scene::Scene>(prepared), file);
        for (const auto& word : GetParam().words(read_file(file)))
          if (!known_.contains(word)) unknown.insert(fmt::format("{}, in {}", word, scene.name));
      }
  EXPECT_TRUE(unknown.empty()) << fmt::format("{}", fmt::join(unknown, "\n"));
  EXPECT_GE(exported, 30);
}

TEST_P(PeerWords, OfItsCommandAreThoseOfTheProgram) {
  int options = 0;
  for (const auto& word : renderer_.command.words) {
    if (!word.starts_with('-')) continue;
    ++options;
    EXPECT_TRUE(known_.contains("option " + word)) << word;
  }
  EXPECT_GT(options, 0);
}

// The option is a bare name; its type beside it ended every scene.
TEST(PbrtWords, AnOptionWithATypeIsNone) {
  const auto table = known({"pbrt", tests::pbrt_words});
  const std::set<std::string> bare{"Option disabletexturefiltering"};
  const std::set<std::string> typed{"Option bool disabletexturefiltering"};
  EXPECT_EQ(tests::pbrt_words("Option \"disabletexturefiltering\" true\n"), bare);
  EXPECT_EQ(tests::pbrt_words("Option \"bool disabletexturefiltering\" true\n"), typed);
  EXPECT_TRUE(table.contains(*bare.begin()));
  EXPECT_FALSE(table.contains(*typed.begin()));
}

}  // namespace
