#pragma once

#include "image/image.h"
#include "metrics/mask.h"
#include "metrics/noise_test.h"
#include "registry/cases.h"
#include "results/record.h"

#include <optional>
#include <string>
#include <vector>

/// What an image must keep beside the gate of ORB.S: the mean of each channel, that of each tile, how sharp
/// its edges are, and how its light is polarised.
namespace orbs::runner {

/// Comparable images and what is known about their noise.
struct JudgedPair {
  const image::Image& result;
  const image::Image& reference;
  const metrics::Mask& mask;
  const metrics::NoiseTest& noise;
};

/// Adds a check for each tolerance of the case, the measures that these rest on, and takes over the verdict
/// of one that is not kept.
void check_tolerances(const registry::Case& one_case, const JudgedPair& pair, results::TargetRecord& record);

/// A worse verdict takes over, with its reason.
void take(results::TargetRecord& record, results::Verdict verdict, const std::string& reason);

/// x0, y0, x1, y1; empty for nothing.
std::vector<double> rectangle_numbers(const std::optional<metrics::Rectangle>& where);

}  // namespace orbs::runner
