#pragma once

#include "history/change.h"
#include "history/pair_runs.h"

#include <optional>
#include <string>
#include <vector>

/// Changes of the numbers that an image is judged by, told from noise by the intervals that the records have.
namespace orbs::history {

/// A number with its standard error, which is 0 where there is no noise.
struct Estimate {
  double value = 0;
  double error = 0;
};

/// The mean of a channel, 'r', 'g' or 'b', over that of the reference, less 1, by its interval. Nothing if
/// the record has none. The interval holds the noise of the reference, too, which two runs share, and the
/// tails of Student's distribution: the error is too large rather than too small.
std::optional<Estimate> mean_light(const results::TargetRecord& target, char channel);

/// The mean squared error with its standard error: that of bias_squared, which is mse less a variance, by its
/// interval.
std::optional<Estimate> mean_squared_error(const results::TargetRecord& target);

/// Tests whether the means of the channels differ: for each target, and for each renderer over all of its
/// targets together, where a change that is too small to be seen in one target shows. Scenes that several
/// cases judge count once, differences of scenes not.
std::vector<Candidate> light_candidates(const RunPair& pair);

/// Tests whether the mean squared error of each target differs, where both images have the same samples: as a
/// verdict asks for as many as it needs, other numbers of them are no change of a renderer.
std::vector<Candidate> error_candidates(const RunPair& pair);

}  // namespace orbs::history
