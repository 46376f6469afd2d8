#include "run/resume.h"

#include <gtest/gtest.h>

using namespace orbs;

namespace {

std::string hash_of(const registry::Renderer& entry, int spp) {
  run::Plan plan;
  plan.scenes.push_back({"s", "s.json", spp, std::make_shared<const scene::Scene>()});
  plan.renderers.push_back({entry, "/usr/bin/r"});
  run::PlannedJob job;
  job.spp = spp;
  return run::settings_hash(plan, job);
}

std::string hash_of_command(const std::vector<std::string>& command, int spp) {
  registry::Renderer entry;
  entry.name = "r";
  entry.format.name = "povray";
  entry.command.words = command;
  return hash_of(entry, spp);
}

}  // namespace

// What an exporter makes of a placeholder is a setting, too: an image with another depth is another image.
TEST(Outdated, SettingsAreTheWordsThatTheJobGets) {
  const std::vector<std::string> command{"{executable}", "{scene}", "{output}", "+R{aa_grid}"};
  EXPECT_NE(hash_of_command(command, 256), hash_of_command(command, 257));
  EXPECT_EQ(hash_of_command(command, 200), hash_of_command(command, 256));
  EXPECT_NE(hash_of_command(command, 256),
            hash_of_command({"{executable}", "{scene}", "{output}", "+R5"}, 256));
}

namespace {

// Gives the member number `chosen` of an entry another value; notes its key, and whether it says of itself
// that it changes the image.
struct ChangeOne {
  int chosen = 0;
  int count = 0;
  std::string key{};
  bool changes_image = true;

  template <class T>
  void operator()(const std::string& name, T& value, const json::Field& field = {}) {
    if (count++ != chosen) return;
    key = name;
    changes_image = field.changes_image;
    change(value);
  }
  template <class T>
  void required(const std::string& name, T& value, const json::Field& field = {}) {
    (*this)(name, value, field);
  }

  // The exporters know the words of "scene_format".
  void change(std::string& text) { text = text == "povray" ? "pbrt" : text + "x"; }
  void change(int& number) { ++number; }
  void change(double& number) { number += 1; }
  void change(bool& flag) { flag = !flag; }
  void change(std::vector<std::string>& words) { words.emplace_back("x"); }
  void change(registry::FeatureSet& features) { features['M'].insert(3); }
  void change(registry::RenderSeconds& seconds) { seconds.pattern += "x"; }
  void change(registry::ImageSequence& sequence) { sequence.suffix += "x"; }
  template <class T>
  void change(std::vector<T>& items) {
    items.emplace_back();
  }
  template <class Key, class T>
  void change(std::map<Key, T>& items) {
    items[Key{}];
  }
};

}  // namespace

// A member that is added to an entry enters the hash by itself: nobody has to remember --resume.
TEST(Outdated, EveryFieldOfAnEntryIsHashedUnlessItSaysOtherwise) {
  registry::Renderer entry;
  entry.name = "r";
  entry.format.name = "povray";
  entry.command.words = {"{executable}", "{scene}", "{output}", "{transport}", "{seed}", "{plugin}"};
  const auto plain = hash_of(entry, 16);
  int hashed = 0;
  for (int i = 0;; ++i) {
    auto changed = entry;
    ChangeOne change{i};
    fields(change, changed);
    if (change.key.empty()) break;
    EXPECT_EQ(hash_of(changed, 16) != plain, change.changes_image) << change.key;
    hashed += change.changes_image ? 1 : 0;
  }
  EXPECT_GE(hashed, 10);
}
