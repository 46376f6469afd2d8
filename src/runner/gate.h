#pragma once

#include "image/image.h"
#include "metrics/mask.h"
#include "metrics/noise_test.h"
#include "registry/cases.h"
#include "results/verdict.h"

#include <array>
#include <optional>
#include <string>

namespace orbs::runner {

/// What is known about the noise of an image and its reference when a gate is looked at.
struct GateNoise {
  std::optional<double> result_mse;  // in psnr_srgb8's steps, see noise_mse_srgb8; nothing: unknown
  std::optional<double> reference_mse;
  std::string bias;  // what differs by more than noise, "" for nothing: metrics::bias_message
};

GateNoise gate_noise(const image::Image& result,
                     const image::Image& reference,
                     const metrics::Mask& mask,
                     const metrics::NoiseTest& test);

struct GateResult {
  results::Verdict verdict = results::Verdict::Pass;
  std::string reason;
};

/// Whether `value` meets the gate. A psnr_srgb8 that is too low is Inconclusive, with how many times the
/// samples are needed, where the noise of both images alone explains it and no test sees a bias; else Fail.
GateResult check_gate(const registry::Gate& gate, std::optional<double> value, const GateNoise& noise);

/// Whether the mean of a channel ("R") is within `tolerance` of the reference's, relative to it: Fail where
/// its whole interval lies beyond, Pass where all of it lies within, else Inconclusive. Without a ratio (a
/// black channel) there is nothing to meet: Pass.
GateResult check_mean_ratio(const std::string& channel,
                            double tolerance,
                            const std::optional<metrics::Estimate>& ratio);

}  // namespace orbs::runner
