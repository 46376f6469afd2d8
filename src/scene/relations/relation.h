#pragma once

#include "scene/scene.h"

#include <string>
#include <string_view>
#include <variant>
#include <vector>

/// Relations (metamorphic testing: Chen, Cheung and Yiu 1998): changes of a scene whose effect on the image
/// is known exactly, so that any renderer can be tested without a reference.
namespace orbs::scene {

/// What the image of the changed scene is, in terms of the image of the original one.
struct SameImage {};
struct MirroredImage {};  // left and right are exchanged
struct MultipliedImage {
  double factor = 1;  // a power of two, by which floats are multiplied without rounding
};
struct RotatedChannels {};  // R, G, B are the former G, B, R
using RelatedImage = std::variant<SameImage, MirroredImage, MultipliedImage, RotatedChannels>;

struct RelatedScenes {
  Scene original;  // the scene itself, or a form of it that the relation starts from
  Scene changed;
  RelatedImage image;
};

/// The two scenes, or why the relation has nothing to change in this one.
using Related = std::variant<RelatedScenes, std::string>;

struct Relation {
  std::string_view name;
  std::string_view change;         // what is done to the scene
  std::string_view unit;           // of the magnitude; "" for a ratio
  std::vector<double> magnitudes;  // from the easiest to the hardest; {1} for a relation without magnitude
  bool is_exact = false;           // floats must follow it to the bit
  Related (*apply)(const Scene&, double magnitude) = nullptr;
};

/// All relations, in the order in which tables show them.
const std::vector<Relation>& relations();

/// A relation with more than one magnitude, or with one that is not 1.
bool is_sweep(const std::vector<double>& magnitudes);

}  // namespace orbs::scene
