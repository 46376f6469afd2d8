#pragma once

#include "metrics/l1.h"
#include "metrics/mse.h"
#include "metrics/psnr.h"
#include "metrics/ssim.h"

#include <array>
#include <string_view>

namespace orbs::metrics {

/// Every metric there is. To add one: its file, and its line here.
inline constexpr std::array kMetrics{
    kL1, kMse, kPsnrSrgb8, kPsnrLinear, kSsim,
};

/// The metric of this name. InputError that lists the metrics when there is none.
const MetricInfo& find_metric(std::string_view name);

}  // namespace orbs::metrics
