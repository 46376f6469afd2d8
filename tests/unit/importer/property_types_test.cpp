// Values of another type or length than glTF says: each is refused with its place, whatever else the file
// holds. The library takes them, and what follows in their object, as if they were not there.
#include "unit/importer/made_gltf.h"

#include <set>

#include <gtest/gtest.h>

namespace {

using namespace orbs;
using importer_tests::ImportFolder;
using importer_tests::MadeGltf;
using nlohmann::json;

json texture_info() {
  return {{"index", 0},
          {"texCoord", 0},
          {"extensions",
           {{"KHR_texture_transform",
             {{"offset", {0.5, 0}}, {"scale", {1, 1}}, {"rotation", 0.0}, {"texCoord", 0}}}}}};
}

json materials() {
  auto normal = texture_info();
  normal["scale"] = 0.5;
  auto occlusion = texture_info();
  occlusion["strength"] = 0.5;
  return json::array(
      {{{"name", "paint"},
        {"doubleSided", true},
        {"alphaMode", "MASK"},
        {"alphaCutoff", 0.25},
        {"emissiveFactor", {0, 0, 0}},
        {"emissiveTexture", texture_info()},
        {"normalTexture", normal},
        {"occlusionTexture", occlusion},
        {"pbrMetallicRoughness",
         {{"baseColorFactor", {0.5, 0.5, 0.5, 1}},
          {"baseColorTexture", texture_info()},
          {"metallicFactor", 0.5},
          {"roughnessFactor", 0.5},
          {"metallicRoughnessTexture", texture_info()}}},
        {"extensions",
         {{"KHR_materials_emissive_strength", {{"emissiveStrength", 2.0}}},
          {"KHR_materials_ior", {{"ior", 1.5}}},
          {"KHR_materials_specular", {{"specularFactor", 1.0}, {"specularColorFactor", {1, 1, 1}}}},
          {"KHR_materials_transmission", {{"transmissionFactor", 0.0}}},
          {"KHR_materials_volume", {{"thicknessFactor", 0.0}, {"attenuationDistance", 1.0}}}}}}});
}

// A file with the properties that the importer reads.
MadeGltf with_all() {
  auto made = importer_tests::triangle();
  made.json["images"] = json::array({{{"name", "wood"}, {"mimeType", "image/png"}, {"bufferView", 0}}});
  const int image = made.add_image({{255, 0, 0}, {0, 0, 255}});
  made.json["images"][0]["bufferView"] = made.json["images"][static_cast<std::size_t>(image)]["bufferView"];
  made.add("samplers", {{"magFilter", 9728}, {"wrapS", 33071}, {"wrapT", 33648}});
  made.add("textures", {{"name", "wood"}, {"sampler", 0}, {"source", 0}});
  made.json["materials"] = materials();
  auto& primitive = made.json["meshes"][0]["primitives"][0];
  primitive["mode"] = 4;
  primitive["targets"] = json::array({{{"POSITION", primitive["attributes"]["POSITION"]}}});
  made.json["meshes"][0]["weights"] = {0.0};
  made.json["accessors"][0]["byteOffset"] = 0;
  made.json["accessors"][0]["normalized"] = false;
  made.add("cameras",
           {{"name", "eye"},
            {"type", "perspective"},
            {"perspective", {{"aspectRatio", 1.5}, {"yfov", 0.5}, {"znear", 0.1}, {"zfar", 100.0}}}});
  made.add("cameras", {{"type", "orthographic"},
                       {"orthographic", {{"xmag", 1.5}, {"ymag", 0.5}, {"znear", 0.1}, {"zfar", 100.0}}}});
  made.json["extensions"]["KHR_lights_punctual"]["lights"] =
      json::array({{{"name", "lamp"},
                    {"type", "spot"},
                    {"color", {1, 1, 1}},
                    {"intensity", 3.0},
                    {"range", 9.0},
                    {"spot", {{"innerConeAngle", 0.25}, {"outerConeAngle", 0.5}}}}});
  made.add("nodes", {{"translation", {0, 0, 2.5}},
                     {"rotation", {0, 0, 0, 1}},
                     {"scale", {1, 1, 1}},
                     {"camera", 0},
                     {"children", {2}},
                     {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
  made.add("nodes", {{"matrix", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}}});
  made.json["scenes"][0]["nodes"] = {0, 1};
  made.add("skins", {{"name", "bones"}, {"inverseBindMatrices", 0}, {"joints", {1}}});
  return made;
}

// The places of all values, objects and lists among them.
void add_places(const json& value, const json::json_pointer& at, std::vector<json::json_pointer>& places) {
  if (!at.empty()) places.push_back(at);
  if (value.is_object())
    for (const auto& [key, member] : value.items()) add_places(member, at / key, places);
  else if (value.is_array())
    for (std::size_t i = 0; i < value.size(); ++i) add_places(value[i], at / i, places);
}

std::vector<json> of_other_types(const json& value) {
  std::vector<json> others;
  for (const auto& other : {json(3), json("three"), json(true), json::array({json::array()}),
                            json::array({json::object()}), json{{"three", "3"}}, json(nullptr)}) {
    const bool is_alike = value.is_number() ? other.is_number() : value.type() == other.type();
    if (!is_alike) others.push_back(other);
  }
  if (value.is_number_integer()) others.insert(others.end(), {json(0.5), json(-1), json(1.0)});
  return others;
}

// A number may be written without a fraction where any is expected.
bool is_whole_by_chance(const json::json_pointer& place) {
  static const std::set<std::string> kNumbers{"emissiveFactor", "baseColorFactor", "specularColorFactor",
                                              "offset",         "scale",           "color",
                                              "translation",    "rotation",        "matrix"};
  return kNumbers.contains(place.parent_pointer().empty() ? "" : place.parent_pointer().back());
}

void expect_refused_at(const MadeGltf& made, const json::json_pointer& place) {
  const ImportFolder folder;
  const auto message = folder.refusal(made);
  EXPECT_NE(message.find(place.to_string()), std::string::npos)
      << place.to_string() << " = " << made.json[place].dump() << "\n"
      << message;
}

TEST(GltfPropertyTypes, AFileWithAllIsRead) {
  const ImportFolder folder;
  const auto imported = folder.import(with_all());
  EXPECT_EQ(imported.scene.meshes.size(), 1U);
  EXPECT_EQ(imported.scene.lights.size(), 1U);
}

TEST(GltfPropertyTypes, AnotherTypeIsRefusedWithItsPlaceWhereverItStands) {
  const auto whole = with_all();
  std::vector<json::json_pointer> places;
  add_places(whole.json, json::json_pointer(), places);
  ASSERT_GT(places.size(), 200U);
  for (const auto& place : places) {
    const auto& value = whole.json[place];
    for (const auto& other : of_other_types(value)) {
      if (other.is_number() && is_whole_by_chance(place)) continue;
      auto made = whole;
      made.json[place] = other;
      expect_refused_at(made, place);
    }
  }
}

TEST(GltfPropertyTypes, AnotherLengthIsRefusedWithItsPlace) {
  static const std::set<std::string> kOfALength{"emissiveFactor", "baseColorFactor", "specularColorFactor",
                                                "offset",         "scale",           "color",
                                                "translation",    "rotation",        "matrix"};
  const auto whole = with_all();
  std::vector<json::json_pointer> places;
  add_places(whole.json, json::json_pointer(), places);
  int count = 0;
  for (const auto& place : places) {
    if (!kOfALength.contains(place.back()) || !whole.json[place].is_array()) continue;
    ++count;
    auto longer = whole;
    longer.json[place].push_back(0);
    expect_refused_at(longer, place);
    auto shorter = whole;
    shorter.json[place].erase(0);
    expect_refused_at(shorter, place);
  }
  EXPECT_GE(count, 9);
}

TEST(GltfPropertyTypes, WhatIsMissingWhereItMustBeIsNamed) {
  for (const std::string place :
       {"/materials/0/pbrMetallicRoughness/baseColorTexture/index", "/cameras/0/perspective/yfov",
        "/nodes/1/extensions/KHR_lights_punctual/light", "/meshes/0/primitives/0/attributes",
        "/skins/0/joints"}) {
    auto made = with_all();
    const json::json_pointer at(place);
    made.json[at.parent_pointer()].erase(at.back());
    const ImportFolder folder;
    const auto message = folder.refusal(made);
    EXPECT_NE(message.find(at.parent_pointer().to_string()), std::string::npos) << message;
    EXPECT_NE(message.find(at.back()), std::string::npos) << message;
  }
}

}  // namespace
