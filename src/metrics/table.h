#pragma once

#include "metrics/error_quantiles.h"
#include "metrics/flip.h"
#include "metrics/l1.h"
#include "metrics/mse.h"
#include "metrics/psnr.h"
#include "metrics/psnr_pu21.h"
#include "metrics/relmse.h"
#include "metrics/smape.h"
#include "metrics/ssim.h"
#include "metrics/ssim_jeri.h"
#include "metrics/worst_tile.h"

#include <array>
#include <string_view>

namespace orbs::metrics {

/// Every metric there is. To add one: its file, and its line here.
inline constexpr std::array kMetrics{
    kL1,       kMse,      kPsnrSrgb8, kPsnrLinear, kSsim, kRelMse,  kRelMseTrimmed, kSmape,
    kErrorP95, kErrorP99, kErrorMax,  kWorstTile,  kFlip, kHdrFlip, kPsnrPu21,      kSsimJeri,
};

/// The metric of this name. InputError that lists the metrics when there is none.
const MetricInfo& find_metric(std::string_view name);

}  // namespace orbs::metrics
