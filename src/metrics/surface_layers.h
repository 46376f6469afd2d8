#pragma once

#include "metrics/metric.h"

#include <string>
#include <string_view>

/// Layers of surfaces (AOVs): depth, normals, albedo, texture coordinates and numbers of things, in the forms
/// of image/layers.h. They have next to no noise, so single pixels are judged; a renderer may take a mean
/// over the pixel or any one sample of it.
namespace orbs::metrics {

/// In how many pixels a layer shows what nothing there has. Of a mean that is a value beyond the range of all
/// that the reference shows in the pixel and its eight neighbours, by more than a step of a half float, in
/// which some renderers write, and the rounding of single precision; only where a surface covers the whole
/// pixel, as renderers differ in what they write beside it. Of the coverage it is any other than that of the
/// pixel and its neighbours where these agree that it is 0 or 1. Of numbers it is one that none of the things
/// in the pixel and beside it has: a renderer may number as it likes, each thing by one number, and each
/// number for one thing.
MetricResult compute_layer_pixels(const ImagePair& pair);

/// The largest relative difference of a layer's means that is there for certain, over windows of 8 px and
/// more (layer_windows.h), or what is certain of the error of a coverage, in the mean of 8 x 8 px, or at its
/// edges (coverage_edges.h). It calls a right image wrong in one of 10,000 over all windows, channels and
/// looks together. Half a pixel of shift is beyond it, and so are a depth along the ray or one that is off by
/// 1 %. Numbers of things do not count.
MetricResult compute_layer_error(const ImagePair& pair);

std::string describe_layer_pixels(const Measurement& measurement, const Limits& limits);
std::string describe_layer_error(const Measurement& measurement, const Limits& limits);

inline constexpr MetricInfo kLayerPixels{
    "layer_pixels",
    "px",
    Better::Lower,
    "number of unmasked pixels in which a layer of surfaces (AOV) lies beyond the range that the reference shows in "
    "the pixel and its 8 neighbours, or in which a number stands for another thing; albedos are linear Rec.709, all "
    "else plain numbers; no clamp",
    {"layers",
     "the farthest that a layer lies beyond its range, over its largest value in the reference; 1 for a "
     "wrong number",
     false, 0.1F},
    compute_layer_pixels,
    Computed::Always,
    GateRule::Value,
    describe_layer_pixels};

inline constexpr MetricInfo kLayerError{
    "layer_error",
    "1",
    Better::Lower,
    "the largest |mean(result) - mean(reference)| of a channel of a layer of surfaces (AOV), or of the length of its "
    "vectors, relative to what each pixel shows, over the unmasked and covered pixels of a square of 8, 16, 32, ... px, "
    "less the reach of the samples' noise and place; of a coverage what is certain of the error of its means over "
    "8 x 8 px, or of its edges in units of one sample a pixel; albedos are linear Rec.709, all else plain numbers; no "
    "clamp",
    kNoMap,
    compute_layer_error,
    Computed::Always,
    GateRule::Certain,
    describe_layer_error};

/// Whether a metric of this name compares layers of surfaces, and not colours.
inline bool is_of_layers(std::string_view metric) {
  return metric == kLayerPixels.name || metric == kLayerError.name;
}

}  // namespace orbs::metrics
