// The kinds of materials, lights and shapes are each listed in one place, a variant; everything else follows
// it.
#include "json/document.h"
#include "json/object_reader.h"
#include "scene/load/kind.h"
#include "scene/load/load_scene.h"

#include <set>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

namespace {

using namespace orbs;

template <typename... Types>
std::vector<std::string> words_of_variant(std::type_identity<std::variant<Types...>>) {
  return {Types::kType...};
}

std::vector<std::string> all_types() { return words_of_variant(std::type_identity<scene::MaterialModel>{}); }

TEST(Materials, TheSchemaHasTheTypesOfTheVariantInItsOrder) {
  const auto document = json::parse_file(ORBS_SOURCE_DIR "/data/schema/orbs-scene-1.schema.json");
  json::ObjectReader schema(document);
  std::vector<std::string> types;
  for (auto& material : schema.object("$defs").object("material").objects("oneOf"))
    types.push_back(material.object("properties").object("type").text("const"));
  EXPECT_EQ(types, all_types());
}

// The words of the types in the schema's list of forms of an entry.
std::set<std::string> words_of_schema(const std::string& definition) {
  const auto document = json::parse_file(ORBS_SOURCE_DIR "/data/schema/orbs-scene-1.schema.json");
  json::ObjectReader schema(document);
  std::set<std::string> words;
  for (auto& form : schema.object("$defs").object(definition).objects("oneOf")) {
    auto type = form.object("properties").object("type");
    const auto several = type.has("enum") ? type.texts("enum") : std::vector{type.text("const")};
    words.insert(several.begin(), several.end());
  }
  return words;
}

template <typename Variant>
std::set<std::string> words_of_kinds() {
  const auto words = scene::KindLoader<Variant>::words();
  return {words.begin(), words.end()};
}

TEST(Kinds, TheSchemaHasTheLightsAndShapesOfTheVariants) {
  EXPECT_EQ(words_of_schema("light"), words_of_kinds<scene::LightShape>());
  EXPECT_EQ(words_of_schema("shape_form"), words_of_kinds<scene::ShapeForm>());
}

TEST(Kinds, AnUnknownLightOrShapeIsAnsweredWithAllWords) {
  for (const auto& [key, words] : {std::pair{"lights", words_of_kinds<scene::LightShape>()},
                                   std::pair{"shapes", words_of_kinds<scene::ShapeForm>()}})
    try {
      scene::load_scene_text("s.json",
                             fmt::format(R"({{"format": "orbs-scene/1", "name": "s", "materials": [],
        "camera": {{"position": [0, 0, 1], "look_at": [0, 0, 0]}}, "{}": [{{"type": "ring"}}]}})",
                                         key),
                             ".");
      ADD_FAILURE() << key;
    } catch (const InputError& e) {
      for (const auto& word : words)
        EXPECT_NE(std::string(e.what()).find(word), std::string::npos) << word << " in " << e.what();
    }
}

TEST(Materials, AnUnknownTypeIsAnsweredWithAllTypesAndTheNearest) {
  const std::string text = R"({"format": "orbs-scene/1", "name": "s",
    "camera": {"position": [0, 0, 1], "look_at": [0, 0, 0]},
    "materials": [{"name": "m", "type": "rough_glas"}]})";
  try {
    scene::load_scene_text("s.json", text, ".");
    FAIL();
  } catch (const InputError& e) {
    const std::string message = e.what();
    for (const auto& type : all_types()) EXPECT_NE(message.find(type), std::string::npos) << type;
    EXPECT_NE(message.find("s.json:3"), std::string::npos) << message;
    EXPECT_NE(message.find("(did you mean 'rough_glass'?)"), std::string::npos) << message;
  }
}

}  // namespace
