#pragma once

#include "metrics/edge_blur.h"
#include "metrics/error_quantiles.h"
#include "metrics/flip.h"
#include "metrics/local_bias.h"
#include "metrics/mean_ratio.h"
#include "metrics/noise_numbers.h"
#include "metrics/pixel_errors.h"
#include "metrics/psnr.h"
#include "metrics/ssim.h"
#include "metrics/ssim_jeri.h"
#include "metrics/stokes.h"
#include "metrics/stokes_scale.h"
#include "metrics/surface_layers.h"
#include "metrics/window_numbers.h"
#include "metrics/worst_tile.h"

#include <array>
#include <string_view>

namespace orbs::metrics {

/// Every number by which two images are compared; each can be a gate. To add one: its file, and its line
/// here.
inline constexpr std::array kMetrics{
    kL1,           kMse,           kPsnrSrgb8,     kPsnrLinear,      kSsim,
    kRelMse,       kRelMseTrimmed, kSmape,         kErrorP95,        kErrorP99,
    kErrorMax,     kWorstTile,     kFlip,          kHdrFlip,         kPsnrPu21,
    kSsimJeri,     kMeanRatioR,    kMeanRatioG,    kMeanRatioB,      kLocalBias,
    kWindowError8, kWindowError16, kWindowError64, kLineError,       kPatternError,
    kEdgeBlur,     kStokesError,   kStokesScale1,  kStokesScale2,    kStokesScale3,
    kStokesTurn,   kLayerPixels,   kLayerError,    kNoiseSquared,    kBiasSquared,
    kSharedNoise,  kBlocksOff,     kBlockZMax,     kSmallestError16, kSmallestError64,
    kPixelZMax,    kPixelsBeyond3,
};

/// The metric of this name. InputError that lists the metrics when there is none.
const MetricInfo& find_metric(std::string_view name);

}  // namespace orbs::metrics
