#pragma once

#include "image/image.h"
#include "image/layers.h"

#include <optional>
#include <string>
#include <vector>

namespace orbs::metrics {

/// One channel of a layer in two images, by pixels. `least` and `most` are the ends of what the pixel of the
/// reference shows; where the reference does not know them they are its value.
struct LayerChannel {
  std::string name;  // "normal.X"
  std::vector<float> result;
  std::vector<float> reference;
  std::vector<float> least;
  std::vector<float> most;
};

struct ComparedLayer {
  const image::LayerInfo* layer = nullptr;  // of image::kLayers
  std::vector<LayerChannel> channels;
};

/// The layers of surfaces (AOVs) that the reference holds.
struct LayerSamples {
  std::vector<ComparedLayer> layers;  // that both images hold
  std::vector<std::string> missing;   // in the result, by name: "depth"
  std::vector<float> coverage;        // of the reference, by pixels; 1 where it holds none
};

/// Nothing where the reference holds no layer. Where its header says for which the scene asks
/// ("orbs.layers"), others, as the coverage that comes with them, are not compared.
std::optional<LayerSamples> layer_samples(const image::Image& result, const image::Image& reference);

}  // namespace orbs::metrics
