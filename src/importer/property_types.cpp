#include "importer/property_types.h"

#include "json/object_reader.h"

#include <cstddef>
#include <limits>
#include <span>
#include <string>

#include <fmt/format.h>

// Its own, as many of its names are those of other files here.
namespace orbs::importer::property_types {

namespace {

// Sizes and indices: the specification has them written without a fraction, and the library takes 1.0 for no
// integer.
enum class Type {
  Number,
  Size,
  Index,
  Boolean,
  Text,
  Mode,
  Numbers,
  Indices,
  Object,
  Objects,
  Attributes,
  Targets
};

struct Property {
  const char* key;
  Type type;
  std::size_t length = 0;                  // of Numbers; 0: any
  std::span<const Property> members = {};  // of Object and Objects
  bool is_required = false;
};

using enum Type;
constexpr bool kRequired = true;

// The properties of glTF 2.0 and of the extensions that the importer reads, by chapter 5 of the
// specification (https://registry.khronos.org/glTF/specs/2.0/glTF-2.0.html) and the extensions' own.
constexpr Property kTransform[]{
    {"offset", Numbers, 2}, {"scale", Numbers, 2}, {"rotation", Number}, {"texCoord", Index}};
constexpr Property kTextureExtensions[]{{"KHR_texture_transform", Object, 0, kTransform}};
constexpr Property kTextureInfo[]{{"index", Index, 0, {}, kRequired},
                                  {"texCoord", Index},
                                  {"scale", Number},     // of a normal map
                                  {"strength", Number},  // of an occlusion map
                                  {"extensions", Object, 0, kTextureExtensions}};

constexpr Property kMetallicRoughness[]{{"baseColorFactor", Numbers, 4},
                                        {"baseColorTexture", Object, 0, kTextureInfo},
                                        {"metallicFactor", Number},
                                        {"roughnessFactor", Number},
                                        {"metallicRoughnessTexture", Object, 0, kTextureInfo}};
constexpr Property kEmissiveStrength[]{{"emissiveStrength", Number}};
constexpr Property kIor[]{{"ior", Number}};
constexpr Property kSpecular[]{{"specularFactor", Number},
                               {"specularTexture", Object, 0, kTextureInfo},
                               {"specularColorFactor", Numbers, 3},
                               {"specularColorTexture", Object, 0, kTextureInfo}};
constexpr Property kTransmission[]{{"transmissionFactor", Number},
                                   {"transmissionTexture", Object, 0, kTextureInfo}};
constexpr Property kVolume[]{{"thicknessFactor", Number},
                             {"thicknessTexture", Object, 0, kTextureInfo},
                             {"attenuationDistance", Number},
                             {"attenuationColor", Numbers, 3}};
constexpr Property kMaterialExtensions[]{{"KHR_materials_emissive_strength", Object, 0, kEmissiveStrength},
                                         {"KHR_materials_ior", Object, 0, kIor},
                                         {"KHR_materials_specular", Object, 0, kSpecular},
                                         {"KHR_materials_transmission", Object, 0, kTransmission},
                                         {"KHR_materials_unlit", Object},
                                         {"KHR_materials_volume", Object, 0, kVolume}};
constexpr Property kMaterial[]{{"name", Text},
                               {"pbrMetallicRoughness", Object, 0, kMetallicRoughness},
                               {"normalTexture", Object, 0, kTextureInfo},
                               {"occlusionTexture", Object, 0, kTextureInfo},
                               {"emissiveTexture", Object, 0, kTextureInfo},
                               {"emissiveFactor", Numbers, 3},
                               {"alphaMode", Mode},
                               {"alphaCutoff", Number},
                               {"doubleSided", Boolean},
                               {"extensions", Object, 0, kMaterialExtensions}};

constexpr Property kSparseIndices[]{{"bufferView", Index, 0, {}, kRequired},
                                    {"byteOffset", Size},
                                    {"componentType", Index, 0, {}, kRequired}};
constexpr Property kSparseValues[]{{"bufferView", Index, 0, {}, kRequired}, {"byteOffset", Size}};
constexpr Property kSparse[]{{"count", Size, 0, {}, kRequired},
                             {"indices", Object, 0, kSparseIndices, kRequired},
                             {"values", Object, 0, kSparseValues, kRequired}};
constexpr Property kAccessor[]{{"bufferView", Index},
                               {"byteOffset", Size},
                               {"componentType", Index, 0, {}, kRequired},
                               {"normalized", Boolean},
                               {"count", Size, 0, {}, kRequired},
                               {"type", Text, 0, {}, kRequired},
                               {"sparse", Object, 0, kSparse}};
constexpr Property kBuffer[]{{"uri", Text}, {"byteLength", Size, 0, {}, kRequired}};
constexpr Property kView[]{{"buffer", Index, 0, {}, kRequired},
                           {"byteOffset", Size},
                           {"byteLength", Size, 0, {}, kRequired},
                           {"byteStride", Size}};

constexpr Property kPrimitive[]{{"attributes", Attributes, 0, {}, kRequired},
                                {"indices", Index},
                                {"material", Index},
                                {"mode", Index},
                                {"targets", Targets},
                                {"extensions", Object}};
constexpr Property kMesh[]{
    {"name", Text}, {"primitives", Objects, 0, kPrimitive, kRequired}, {"weights", Numbers}};
constexpr Property kSkin[]{
    {"name", Text}, {"inverseBindMatrices", Index}, {"joints", Indices, 0, {}, kRequired}};

constexpr Property kNodeLight[]{{"light", Index, 0, {}, kRequired}};
constexpr Property kNodeExtensions[]{{"KHR_lights_punctual", Object, 0, kNodeLight}};
constexpr Property kNode[]{{"name", Text},
                           {"camera", Index},
                           {"children", Indices},
                           {"skin", Index},
                           {"matrix", Numbers, 16},
                           {"mesh", Index},
                           {"rotation", Numbers, 4},
                           {"scale", Numbers, 3},
                           {"translation", Numbers, 3},
                           {"weights", Numbers},
                           {"extensions", Object, 0, kNodeExtensions}};
constexpr Property kSceneEntry[]{{"name", Text}, {"nodes", Indices}};

constexpr Property kPerspective[]{
    {"aspectRatio", Number}, {"yfov", Number, 0, {}, kRequired}, {"zfar", Number}, {"znear", Number}};
constexpr Property kOrthographic[]{{"xmag", Number, 0, {}, kRequired},
                                   {"ymag", Number, 0, {}, kRequired},
                                   {"zfar", Number},
                                   {"znear", Number}};
constexpr Property kCamera[]{{"name", Text},
                             {"type", Text, 0, {}, kRequired},
                             {"perspective", Object, 0, kPerspective},
                             {"orthographic", Object, 0, kOrthographic}};

constexpr Property kImage[]{{"name", Text}, {"uri", Text}, {"mimeType", Text}, {"bufferView", Index}};
constexpr Property kSampler[]{{"magFilter", Index}, {"minFilter", Index}, {"wrapS", Index}, {"wrapT", Index}};
constexpr Property kTexture[]{{"name", Text}, {"sampler", Index}, {"source", Index}};

constexpr Property kSpot[]{{"innerConeAngle", Number}, {"outerConeAngle", Number}};
constexpr Property kLight[]{{"name", Text},        {"type", Text, 0, {}, kRequired},
                            {"color", Numbers, 3}, {"intensity", Number},
                            {"range", Number},     {"spot", Object, 0, kSpot}};
constexpr Property kLights[]{{"lights", Objects, 0, kLight, kRequired}};
constexpr Property kFileExtensions[]{{"KHR_lights_punctual", Object, 0, kLights}};

constexpr Property kFile[]{{"accessors", Objects, 0, kAccessor}, {"buffers", Objects, 0, kBuffer},
                           {"bufferViews", Objects, 0, kView},   {"cameras", Objects, 0, kCamera},
                           {"images", Objects, 0, kImage},       {"materials", Objects, 0, kMaterial},
                           {"meshes", Objects, 0, kMesh},        {"nodes", Objects, 0, kNode},
                           {"samplers", Objects, 0, kSampler},   {"scene", Index},
                           {"scenes", Objects, 0, kSceneEntry},  {"skins", Objects, 0, kSkin},
                           {"textures", Objects, 0, kTexture},   {"extensions", Object, 0, kFileExtensions}};

void check_attributes(json::ObjectReader attributes) {
  for (const auto& name : attributes.keys()) {
    attributes.integer(name, 0, std::numeric_limits<int>::max());
    attributes.check_written_whole(name);
  }
}

void check(json::ObjectReader& in, std::span<const Property> properties);

void check_value(json::ObjectReader& in, const Property& property) {
  const std::string key = property.key;
  constexpr double kMostIndex = std::numeric_limits<int>::max();
  constexpr double kMostSize = 9007199254740992;  // 2^53: each whole number up to it is a double
  switch (property.type) {
    case Number:
      in.number(key);
      return;
    case Size:
    case Index:
      in.number(key, {0, property.type == Size ? kMostSize : kMostIndex});
      return in.check_written_whole(key);
    case Boolean:
      in.boolean_or(key, false);
      return;
    case Text:
      in.text(key);
      return;
    case Mode:
      in.one_of(key, {"OPAQUE", "MASK", "BLEND"});
      return;
    case Numbers:
      in.numbers(key, property.length);
      return;
    case Indices:
      in.numbers(key, 0, {0, kMostIndex});
      return in.check_written_whole(key);
    case Object: {
      auto object = in.object(key);
      return check(object, property.members);
    }
    case Objects:
      for (auto& object : in.objects(key)) check(object, property.members);
      return;
    case Attributes:
      return check_attributes(in.object(key));
    case Targets:
      for (const auto& target : in.objects(key)) check_attributes(target);
      return;
  }
}

void check(json::ObjectReader& in, std::span<const Property> properties) {
  for (const auto& property : properties)
    if (property.is_required || in.has(property.key)) check_value(in, property);
}

}  // namespace

}  // namespace orbs::importer::property_types

namespace orbs::importer {

void check_property_types(const json::Document& document) {
  json::ObjectReader file(document);
  property_types::check(file, property_types::kFile);
}

}  // namespace orbs::importer
