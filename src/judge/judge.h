#pragma once

#include "image/image.h"
#include "judge/look.h"
#include "judge/reference.h"
#include "metrics/compare.h"
#include "metrics/mask.h"
#include "metrics/pair_samples.h"
#include "registry/case.h"
#include "results/record.h"

#include <optional>
#include <string>

/// From an image and its reference to a verdict with its reason.
namespace orbs::judge {

/// All masks of one target of the case.
metrics::Mask mask_of(const registry::Case& one_case, const std::string& target);

/// Whether the target is a difference of two scenes, whose pixels may be negative.
bool is_difference(const registry::Case& one_case, const std::string& target);

/// Every metric, or no more than the verdict rests on, which is the same either way.
enum class Measured { Everything, ForTheVerdict };

struct JudgeSettings {
  int threads = 1;
  Measured measured = Measured::Everything;
  metrics::ResultNoise result_noise = metrics::ResultNoise::AsTheImageSays;
  Looks looks = {};
  results::JobCondition condition = {};  // of the render, where its renderer was asked what rounding decides
};

struct Judgement {
  std::optional<metrics::Comparison> comparison;  // for its maps; nothing when there was nothing to compare
  Look look;
};

/// Judges an image of the right size with the channels R, G, B and without NaN or infinite values: whether
/// negative values are allowed, the gates and all other conditions of the case, and whether the image is of
/// one colour. Fills verdict, reason, measures, checks, remarks and provenance of `record`, in which the
/// target is named. Only the images in memory are looked at.
Judgement judge_image(const registry::Case& one_case,
                      const image::Image& result,
                      const Reference& reference,
                      const JudgeSettings& settings,
                      results::TargetRecord& record);

}  // namespace orbs::judge
