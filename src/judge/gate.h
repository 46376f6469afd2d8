#pragma once

#include "image/image.h"
#include "judge/gate_result.h"
#include "metrics/image_pair.h"
#include "metrics/metric.h"
#include "registry/case.h"
#include "results/record.h"
#include "results/verdict.h"

namespace orbs::judge {

/// Whether the measurement meets the gate, by the rule of its metric (metrics::GateRule): Pass, Fail, or
/// Inconclusive where noise does not let it be told, with how many times the samples are needed. `pair` is
/// what was measured; its noise decides where the rule is NoiseAware. `of_first_guess`: see
/// check_gate_at_look.
GateResult check_gate(const registry::Gate& gate,
                      const metrics::Measurement& measurement,
                      const metrics::ImagePair& pair,
                      double of_first_guess = 1);

/// InputError for a gate whose metric does not exist, with its place and the nearest name.
void refuse_unknown_metrics(const registry::Case& one_case);

/// Measures the region's mean and compares it as the check says; not measured where it says why not. The
/// image holds the region.
results::Check check_pixels(const registry::PixelCheck& check, const image::Image& image);

/// Of a check that was measured and has not passed: Fail, or Inconclusive where noise could have moved the
/// mean so far: as many standard errors as the check allows, with the degrees of freedom of the region's
/// pixels, or light that its samples may have missed (metrics/rare_light.h). Inconclusive, too, where light
/// is expected and an image that states its noise is black with none: no sample has met the light.
results::Verdict verdict_of_missed_check(const registry::PixelCheck& check, const image::Image& image);

/// How far the mean is off, in tolerances; infinite where none is given.
double excess_of_missed_check(const registry::PixelCheck& check, const image::Image& image);

}  // namespace orbs::judge
