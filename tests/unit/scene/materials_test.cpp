// The types of materials are listed in one place, the variant MaterialModel; everything else follows it.
#include "json/document.h"
#include "json/object_reader.h"
#include "scene/load/load_scene.h"

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
