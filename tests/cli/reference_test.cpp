// References are rendered by the built-in tracer itself.
#include "base/error.h"
#include "base/text.h"
#include "cli/sandbox.h"
#include "image/image_io.h"
#include "judge/provenance.h"
#include "references/history.h"
#include "references/references.h"
#include "registry/configuration.h"

#include <atomic>
#include <functional>

#include <gtest/gtest.h>
#include <unistd.h>

using namespace orbs;
using cli_tests::contains;
using cli_tests::Sandbox;

TEST(Reference, IsNotReplacedWithoutAReason) {
  const Sandbox sandbox;
  const auto before = sandbox.read("references/grey.exr");
  const auto answer = sandbox.orbs({"reference", "-s", "grey", "--spp", "4"});
  EXPECT_EQ(answer.status, 2);
  EXPECT_TRUE(contains(answer.text, "references exist for grey; say why they may be replaced with --accept"))
      << answer.text;
  EXPECT_EQ(sandbox.read("references/grey.exr"), before);
}

TEST(Reference, ThatIsMissingIsRenderedWhereOthersExist) {
  const Sandbox sandbox;
  std::filesystem::remove(sandbox.folder() / "references" / "grey.exr");
  const auto before = sandbox.read("references/mirror.exr");
  const auto answer = sandbox.orbs({"reference", "-s", "grey,mirror", "--spp", "4"});
  EXPECT_NE(answer.status, 2) << answer.text;
  EXPECT_TRUE(contains(answer.text, "kept, for want of a reason to replace them (--accept): mirror"))
      << answer.text;
  EXPECT_TRUE(sandbox.has("references/grey.exr")) << answer.text;
  EXPECT_EQ(sandbox.read("references/mirror.exr"), before);
}

TEST(Reference, CarriesItsProvenance) {
  const Sandbox sandbox;
  std::filesystem::remove(sandbox.folder() / "references" / "grey.exr");
  const auto answer = sandbox.orbs({"reference", "-s", "grey", "--spp", "16", "--seed", "77"});
  EXPECT_NE(answer.status, 2) << answer.text;
  const auto image = image::read_image(sandbox.folder() / "references" / "grey.exr");
  EXPECT_EQ(image.width, 12);
  EXPECT_EQ(image.channel_count(), 6U);
  EXPECT_GE(image::channel_index(image, "variance.G"), 0);
  const auto& provenance = image.attributes;
  for (const char* key : {"program", "version", "commit", "settings", "spp", "seed", "scene_hash", "cpu",
                          "date", "noise_psnr_srgb8_db", "reason", "image_hash"})
    EXPECT_TRUE(provenance.contains(std::string("orbs.") + key)) << key;
  EXPECT_EQ(provenance.at("orbs.spp"), "16");
  EXPECT_EQ(provenance.at("orbs.seed"), "77");
  EXPECT_EQ(provenance.at("orbs.settings"), "--spp 16 --seed 77");
  EXPECT_FALSE(provenance.contains("orbs.host"));  // references are published
  EXPECT_EQ(provenance.at("orbs.image_hash"), judge::image_hash(image));
  EXPECT_FALSE(sandbox.has("references/grey.history.json"));  // it is the first
}

TEST(Reference, OfAFormulaIsComputed) {
  const Sandbox sandbox;
  std::filesystem::remove(sandbox.folder() / "references" / "grey.exr");
  cli_tests::replace_in(
      sandbox, "cases/m1_grey/case.json", R"("file": "grey.json", "spp": 8})",
      R"("file": "grey.json", "spp": 8, "analytic": {"formula": "constant", "law": "L = rho",
                        "source": "Lambert 1760", "value": [0.5, 0.25, 0.125]}})");
  const auto answer = sandbox.orbs({"reference", "-s", "grey", "-c", "m1_grey"});
  EXPECT_EQ(answer.status, 0) << answer.text;
  const auto image = image::read_image(sandbox.folder() / "references" / "grey.exr");
  EXPECT_EQ(image.channel_count(), 3U);
  EXPECT_EQ(image.at(5, 5, 1), 0.25F);
  const auto& provenance = image.attributes;
  EXPECT_EQ(provenance.at("orbs.kind"), "analytic");
  EXPECT_EQ(provenance.at("orbs.law"), "L = rho");
  EXPECT_EQ(provenance.at("orbs.source"), "Lambert 1760");
  EXPECT_EQ(provenance.at("orbs.image_hash"), judge::image_hash(image));
  EXPECT_FALSE(provenance.contains("orbs.spp"));
}

TEST(Reference, ThatIsReplacedLeavesItsProvenanceInItsHistory) {
  const Sandbox sandbox;
  const auto file = sandbox.folder() / "references" / "grey.exr";
  const auto first = judge::image_hash(image::read_image(file));
  for (const char* reason : {"a scene of its own", "the lamp was moved"})
    EXPECT_NE(sandbox.orbs({"reference", "-s", "grey", "--spp", "4", "--accept", reason}).status, 2);
  const auto history = references::read_history(file);
  ASSERT_EQ(history.size(), 2U);
  EXPECT_EQ(history[0].reason, "a scene of its own");
  EXPECT_EQ(history[0].provenance.at("image_hash"), first);
  EXPECT_EQ(history[1].reason, "the lamp was moved");
  EXPECT_EQ(history[1].provenance.at("reason"), "a scene of its own");
  EXPECT_EQ(history[1].provenance.at("spp"), "4");
}

TEST(Reference, ThatCannotBeReadLeavesThatInItsHistory) {
  const Sandbox sandbox;
  sandbox.write("references/grey.exr", "torn");
  EXPECT_NE(sandbox.orbs({"reference", "-s", "grey", "--spp", "4", "--accept", "torn"}).status, 2);
  const auto history = references::read_history(sandbox.folder() / "references" / "grey.exr");
  ASSERT_EQ(history.size(), 1U);
  EXPECT_NE(history[0].problem, "");
}

TEST(Reference, WithABrokenHistoryIsNotReplaced) {
  const Sandbox sandbox;
  const auto before = sandbox.read("references/grey.exr");
  sandbox.write("references/grey.history.json", "{ torn");
  const auto answer = sandbox.orbs({"reference", "-s", "grey", "--spp", "4", "--accept", "why not"});
  EXPECT_EQ(answer.status, 2);
  EXPECT_TRUE(contains(answer.text, "reading the history of the reference 'grey'")) << answer.text;
  EXPECT_EQ(sandbox.read("references/grey.exr"), before);
}

TEST(Reference, IsNotReplacedForABlankReason) {
  const Sandbox sandbox;
  EXPECT_EQ(sandbox.orbs({"reference", "-s", "grey", "--spp", "4", "--accept", " "}).status, 2);
}

TEST(Reference, WithAReasonIsReplacedAndKeepsIt) {
  const Sandbox sandbox;
  EXPECT_NE(sandbox.orbs({"reference", "-s", "grey", "--spp", "4", "--accept", "the lamp was moved"}).status,
            2);
  const auto image = image::read_image(sandbox.folder() / "references" / "grey.exr");
  EXPECT_EQ(image.attributes.at("orbs.reason"), "the lamp was moved");
}

// A diffuse plane in a white environment: 0.5 everywhere that it is seen, so all light is "ED..." or the
// environment itself.
TEST(Reference, HoldsTheSharesOfPathClassesThatACaseAsksFor) {
  const Sandbox sandbox;
  auto text = sandbox.read("cases/m1_grey/case.json");
  text.insert(text.rfind('}'), R"(, "path_shares": [{"scene": "grey", "class": "EDL", "min_share": 0.01}])");
  sandbox.write("cases/m1_grey/case.json", text);
  EXPECT_NE(sandbox.orbs({"reference", "-s", "grey", "--spp", "4", "--accept", "for the shares"}).status, 2);
  const auto image = image::read_image(sandbox.folder() / "references" / "grey.exr");
  ASSERT_TRUE(image.attributes.contains("orbs.path.EDL"));
  EXPECT_EQ(image.channel_count(), 6U);  // the layers themselves are not kept
}

TEST(Reference, IsRenderedUntilItsNoiseIsTenDecibelsBelowTheGate) {
  const Sandbox sandbox;
  const auto answer = sandbox.orbs({"reference", "-s", "grey", "--accept", "test"});
  EXPECT_EQ(answer.status, 0) << answer.text;
  const auto image = image::read_image(sandbox.folder() / "references" / "grey.exr");
  EXPECT_GE(std::stod(image.attributes.at("orbs.noise_psnr_srgb8_db")), 45);
}

// The first pass is kept, and those that follow have the samples that it lacks.
TEST(Reference, SaysAllPassesThatItIsMadeOf) {
  const Sandbox sandbox;
  auto text = sandbox.read("cases/m1_grey/case.json");
  sandbox.write(
      "cases/m1_grey/case.json",
      text.insert(text.rfind('}'), R"(, "gates": [{"metric": "psnr_srgb8", "min": 55, "reason": "r"}])"));
  EXPECT_EQ(sandbox.orbs({"reference", "-s", "grey", "--seed", "40", "--accept", "test"}).status, 0);
  const auto provenance = image::read_image(sandbox.folder() / "references" / "grey.exr").attributes;
  const auto& settings = provenance.at("orbs.settings");
  ASSERT_TRUE(settings.starts_with("--spp 8 --seed 40 + --spp ")) << settings;
  int spp = 0;
  std::size_t passes = 0;
  for (const auto& pass : split(settings, '+')) {
    const auto words = split(trim(pass), ' ');
    ASSERT_EQ(words.size(), 4U) << settings;
    EXPECT_EQ(words[3], std::to_string(40 + passes++));
    spp += std::stoi(words[1]);
  }
  EXPECT_EQ(provenance.at("orbs.spp"), std::to_string(spp));
}

namespace {

// Several passes, as the gate is high; the call is stopped when it says that one is done.
struct Stoppable {
  Sandbox sandbox;
  std::atomic<bool> stop{false};
  std::string said;

  Stoppable() {
    auto text = sandbox.read("cases/m1_grey/case.json");
    sandbox.write(
        "cases/m1_grey/case.json",
        text.insert(text.rfind('}'), R"(, "gates": [{"metric": "psnr_srgb8", "min": 55, "reason": "r"}])"));
  }
  int render(bool is_to_stop) {
    said.clear();
    return render("test", [this, is_to_stop](const std::string& line) {
      said += line + "\n";
      stop = is_to_stop;
    });
  }
  int render(const std::string& reason, const std::function<void(const std::string&)>& say) {
    stop = false;
    const auto read = registry::load_configuration(sandbox.folder() / "configuration.json");
    auto selection = read.defaults;
    selection.scenes = {"grey"};
    return references::render_references(
        read, selection, {.seed = 40, .reason = reason},
        {std::filesystem::path(ORBS_BINARY_DIR) / "orbs-tracer", &stop, say});
  }
  std::string hash() const {
    return judge::image_hash(image::read_image(sandbox.folder() / "references" / "grey.exr"));
  }
};

}  // namespace

TEST(Reference, ThatWasStoppedGoesOnWithTheFirstPass) {
  Stoppable in_two_calls;
  EXPECT_EQ(in_two_calls.render(true), 130);
  EXPECT_TRUE(contains(in_two_calls.said, "stopped at grey")) << in_two_calls.said;
  EXPECT_EQ(in_two_calls.render(false), 0);
  EXPECT_TRUE(contains(in_two_calls.said, " of a tile, of an earlier call")) << in_two_calls.said;
  EXPECT_FALSE(in_two_calls.sandbox.has("references/.unfinished"));
  Stoppable in_one;
  EXPECT_EQ(in_one.render(false), 0);
  EXPECT_FALSE(contains(in_one.said, "of an earlier call")) << in_one.said;
  EXPECT_EQ(in_two_calls.hash(), in_one.hash());
}

TEST(Reference, ThatWasStoppedBeginsAnewWhenItsSceneHasChanged) {
  Stoppable changed;
  EXPECT_EQ(changed.render(true), 130);
  auto scene = changed.sandbox.read("cases/m1_grey/grey.json");
  const auto reflectance = scene.find("0.5");
  ASSERT_NE(reflectance, std::string::npos);
  changed.sandbox.write("cases/m1_grey/grey.json", scene.replace(reflectance, 3, "0.6"));
  EXPECT_EQ(changed.render(false), 0);
  EXPECT_FALSE(contains(changed.said, "of an earlier call")) << changed.said;
}

// The call that is first would remove the passes of the other.
TEST(Reference, IsNotRenderedByTwoCallsAtOnce) {
  Stoppable scene;
  std::string refusal;
  const auto call_again = [&](const std::string&) {
    if (!refusal.empty()) return;
    refusal = "none";
    try {
      scene.render("test", [](const std::string&) {});
    } catch (const InputError& e) {
      refusal = e.what();
    }
  };
  EXPECT_EQ(scene.render("test", call_again), 0);
  EXPECT_TRUE(contains(refusal, fmt::format("another call, of process {}, renders this reference; wait "
                                            "for its end, or stop it",
                                            ::getpid())))
      << refusal;
  EXPECT_TRUE(contains(refusal, (scene.sandbox.folder() / "references/grey.exr").string())) << refusal;
  EXPECT_FALSE(scene.sandbox.has("references/.unfinished"));
}

// The system lets go of a lock when its process is killed, the file stays.
TEST(Reference, OfACallThatWasKilledIsGoneOnWith) {
  Stoppable scene;
  EXPECT_EQ(scene.render(true), 130);
  scene.sandbox.write("references/.unfinished/.grey.lock", "99999\n");
  EXPECT_EQ(scene.render(false), 0);
  EXPECT_TRUE(contains(scene.said, " of a tile, of an earlier call")) << scene.said;
  EXPECT_FALSE(scene.sandbox.has("references/.unfinished"));
}

TEST(Reference, ThatHasAppearedMeanwhileIsKept) {
  Stoppable scene;
  const auto file = scene.sandbox.folder() / "references/grey.exr";
  std::filesystem::remove(file);
  std::string said;
  scene.render("", [&](const std::string& line) {
    said += line + "\n";
    scene.sandbox.write("references/grey.exr", "of another call");
  });
  EXPECT_EQ(scene.sandbox.read("references/grey.exr"), "of another call");
  EXPECT_TRUE(contains(said, "kept, as it has appeared meanwhile: grey")) << said;
}

TEST(Reference, WhoseFolderCannotBeMadeIsSaidPlainly) {
  const Sandbox sandbox;
  const auto references = sandbox.folder() / "references";
  std::filesystem::remove_all(references);
  sandbox.write("references", "");
  const auto no_folder = sandbox.orbs({"reference", "-s", "grey", "--spp", "4"});
  EXPECT_EQ(no_folder.status, 2);
  EXPECT_EQ(no_folder.text,
            fmt::format("orbs: {}: the folder cannot be made: Not a directory\n", references.string()));
  std::filesystem::remove(references);
  sandbox.write("references/.unfinished", "");
  const auto no_passes = sandbox.orbs({"reference", "-s", "grey", "--spp", "4"});
  EXPECT_EQ(no_passes.status, 2);
  EXPECT_TRUE(contains(no_passes.text, "the folder cannot be made: Not a directory")) << no_passes.text;
}

TEST(Reference, HasTheSamePixelsForTheSameSeed) {
  const Sandbox sandbox;
  const auto pixels = [&] {
    sandbox.orbs({"reference", "-s", "grey", "--accept", "test"});
    return image::read_image(sandbox.folder() / "references" / "grey.exr").pixels;
  };
  const auto first = pixels();
  EXPECT_EQ(pixels(), first);
}

// "mirror" is said to be the same image as "grey".
TEST(Reference, IsNotRenderedForASceneThatIsAnotherOneByDefinition) {
  const Sandbox sandbox;
  auto text = sandbox.read("cases/m3_mirror/case.json");
  const std::string name = R"("name": "mirror",)";
  sandbox.write("cases/m3_mirror/case.json",
                text.replace(text.find(name), name.size(), name + R"( "reference": "grey",)"));
  std::filesystem::remove(sandbox.folder() / "references" / "mirror.exr");
  const auto answer = sandbox.orbs({"reference", "-s", "mirror"});
  EXPECT_EQ(answer.status, 0) << answer.text;
  EXPECT_TRUE(contains(answer.text, "mirror is judged by the reference of grey")) << answer.text;
  EXPECT_FALSE(sandbox.has("references/mirror.exr"));
  EXPECT_EQ(sandbox.orbs({"run", "-r", "good", "-s", "mirror"}).status, 0);
}

TEST(Reference, IsNoneAnyMoreWhenItsSceneHasChanged) {
  const Sandbox sandbox;
  sandbox.orbs({"reference", "-s", "v1.5", "--spp", "4", "--accept", "test"});
  EXPECT_FALSE(contains(sandbox.orbs({"run", "-r", "good", "-s", "v1.5"}).text, "has changed"));
  auto text = sandbox.read("cases/m1_grey/grey.json");
  sandbox.write("cases/m1_grey/grey.json", text.replace(text.find("[0,4,1]"), 7, "[0,4,2]"));
  const auto answer = sandbox.orbs({"run", "-r", "good", "-s", "v1.5"});
  EXPECT_EQ(answer.status, 1);
  EXPECT_TRUE(contains(answer.text, "missing reference")) << answer.text;
  EXPECT_TRUE(
      contains(answer.text, "scene 'v1.5' has changed since its reference was rendered: its hash is now "))
      << answer.text;
}

// The file serves both cases, so the layers that one of them needs are rendered whoever is chosen.
TEST(Reference, IsMadeForAllCasesThatLookAtIt) {
  const Sandbox sandbox;
  auto text = sandbox.read("cases/m3_mirror/case.json");
  text.insert(text.rfind('}'), R"(, "path_shares": [{"scene": "grey", "class": "EDL", "min_share": 0.01}])");
  sandbox.write("cases/m3_mirror/case.json", text);
  EXPECT_NE(
      sandbox.orbs({"reference", "-c", "m1_grey", "-s", "grey", "--spp", "4", "--accept", "test"}).status, 2);
  const auto image = image::read_image(sandbox.folder() / "references" / "grey.exr");
  EXPECT_TRUE(image.attributes.contains("orbs.path.EDL"));
}

TEST(Reference, ChangesItsSceneHashWithTheSceneAlone) {
  const Sandbox sandbox;
  const auto hash = [&] {
    sandbox.orbs({"reference", "-s", "grey", "--spp", "2", "--accept", "test"});
    return image::read_image(sandbox.folder() / "references" / "grey.exr").attributes.at("orbs.scene_hash");
  };
  const auto first = hash();
  EXPECT_EQ(hash(), first);
  auto text = sandbox.read("cases/m1_grey/grey.json");
  sandbox.write("cases/m1_grey/grey.json", text.replace(text.find("[0,4,1]"), 7, "[0,4,2]"));
  EXPECT_NE(hash(), first);
}
