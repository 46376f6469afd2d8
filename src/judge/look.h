#pragma once

#include "image/image.h"
#include "judge/gate_result.h"
#include "metrics/common_noise.h"
#include "results/target_record.h"

#include <array>
#include <vector>

namespace orbs::judge {

/// Of an image that gets samples until it is decided.
struct Looks {
  int most = 1;               // that the error rates hold for; 1: the samples are fixed
  double sample_ratio = 0;    // samples of the reference over those of the image; 0: not known
  double of_first_guess = 1;  // samples of the image over those that its case asks for
  const std::array<image::Image, 2>* halves = nullptr;  // of its samples, see metrics::PairSettings
  std::vector<metrics::RendersApart> apart = {};        // by look
  int spp = 0;
};

/// What one look saw.
struct Look {
  bool is_open = false;  // more samples may change the verdict
  Need need{1, 1};       // of the gate that needs most, where it is open
  GateResult gate = {};  // that decided, or needs most
};

/// The worst verdict of the results, of which there is one at least.
results::Verdict worst_of(const std::vector<GateResult>& results);

/// What a look at an image saw whose gates and checks gave these results: it is open where noise alone leaves
/// the worst of them so. Closed where the samples are fixed.
Look look_at(const std::vector<GateResult>& results, const Looks& looks);

/// The same, open too where only samples can tell whether an image is black for lack of them. `record` holds
/// the verdict.
Look opened_where_early(Look look, const Looks& looks, const results::TargetRecord& record);

}  // namespace orbs::judge
