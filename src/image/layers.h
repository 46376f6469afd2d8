#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

/// The layers of the surface that the camera sees first (arbitrary output variables, AOVs), which an image
/// may hold beside its colour.
namespace orbs::image {

/// What a pixel of the layer holds. Coverage: the share of the pixel in which the camera sees a surface.
/// Mean: the mean over that share. Id: the number of what is seen through the middle of the pixel, from 1;
/// 0 where that is nothing.
enum class LayerKind { Coverage, Mean, Id };

struct LayerInfo {
  std::string_view name;  // "normal"
  LayerKind kind;
  std::array<std::string_view, 3> parts;  // "X", "Y", "Z" of "normal.X"; empty ones are not there
  std::string_view what;
};

/// All layers, in the order in which an image holds them.
inline constexpr std::array kLayers{
    LayerInfo{"coverage", LayerKind::Coverage, {"A"}, "the share of the pixel that shows a surface"},
    LayerInfo{"depth", LayerKind::Mean, {"Z"}, "distance from the camera along its axis, in metres"},
    LayerInfo{"position", LayerKind::Mean, {"X", "Y", "Z"}, "the place in the world, in metres"},
    LayerInfo{
        "normal", LayerKind::Mean, {"X", "Y", "Z"}, "the shading normal in the world, towards the camera"},
    LayerInfo{"albedo", LayerKind::Mean, {"R", "G", "B"}, "the reflectance of the material"},
    LayerInfo{"uv", LayerKind::Mean, {"U", "V"}, "texture coordinates as the mesh gives them"},
    LayerInfo{"instance", LayerKind::Id, {"id"}, "the number of the instance, shape or light"},
    LayerInfo{"object", LayerKind::Id, {"id"}, "the number of the mesh, shape or light"},
    LayerInfo{"material", LayerKind::Id, {"id"}, "the number of the material"},
};

/// Of the ends of the range of values that a pixel shows: "least.normal.X", "most.normal.X".
inline constexpr std::string_view kLeast = "least.";
inline constexpr std::string_view kMost = "most.";

/// Whether the channel holds the variance of another one.
bool is_variance(std::string_view channel);

/// nullptr if there is no such layer.
const LayerInfo* find_layer(std::string_view name);

/// "normal.X", "normal.Y", "normal.Z".
std::vector<std::string> channels_of(const LayerInfo& layer);

/// What becomes of a channel's pixels where several make one. Mean: their mean. VarianceOfMean: the sum over
/// the square of their number. CoveredMean: their mean by coverage. Least, Most: the outermost of them.
/// First: one of them, as numbers of things have no mean.
enum class Combination { Mean, VarianceOfMean, CoveredMean, Least, Most, First };

Combination combination_of(std::string_view channel);

/// Whether it is an end of a range: "least.depth.Z".
bool is_range(std::string_view channel);

/// Whether the channel belongs to one of kLayers, ranges included: it is no colour, has no noise by light,
/// and its digits count.
bool is_layer_channel(std::string_view channel);

/// Whether it stays a 32-bit float in a file of halves.
bool stays_float(std::string_view channel);

}  // namespace orbs::image
