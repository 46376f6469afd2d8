#pragma once

#include "image/image.h"
#include "judge/gate.h"
#include "judge/reference.h"
#include "metrics/compare.h"
#include "metrics/mask.h"
#include "metrics/pair_samples.h"
#include "registry/case.h"
#include "results/record.h"

#include <array>
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

/// Of an image that gets samples until it is decided.
struct Looks {
  int most = 1;               // that the error rates hold for; 1: the samples are fixed
  double sample_ratio = 0;    // samples of the reference over those of the image; 0: not known
  double of_first_guess = 1;  // samples of the image over those that its case asks for
  const std::array<image::Image, 2>* halves = nullptr;  // of its samples, see metrics::PairSettings
};

struct JudgeSettings {
  int threads = 1;
  Measured measured = Measured::Everything;
  metrics::ResultNoise result_noise = metrics::ResultNoise::AsTheImageSays;
  Looks looks = {};
};

/// What one look saw.
struct Look {
  bool is_open = false;  // more samples may change the verdict
  Need need{1, 1};       // of the gate that needs most, where it is open
  GateResult gate = {};  // that decided, or needs most
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
