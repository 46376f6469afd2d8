#pragma once

#include "json/object_reader.h"

#include <optional>
#include <string>
#include <vector>

namespace orbs::registry {

/// One metric with a limit: met when the number of `metric` is not below `min` and not above `max`, as far as
/// its noise allows to tell. A target passes when all gates of its case are met.
struct Gate {
  std::string metric;  // a name of metrics::kMetrics, which this module does not know
  std::optional<double> min = {};
  std::optional<double> max = {};
  std::string reason = {};  // why the case has this gate
  std::string place = {};   // "case.json:12", for complaints about the metric
};

/// The gates of every case unless it overrides them. The first is that of ORB.S (section 2: PSNR above 35 if
/// otherwise is not specified). 4 % more light can pass it, and it does not notice a lost detail in a large
/// image; the others do. Independent renderers that are right keep them: where the models are the same,
/// Cycles' images of the orbs suite differ by 0.3 % in the mean and 6 % in a tile at most, and their edges by
/// 0.05. POV-Ray's anti-aliasing makes 0.12 of that, half the resolution 0.8 to 1.4. The mean's tolerance
/// leaves room for the noise (0.22 % at most): all of a bias of 1 % lies beyond it.
std::vector<Gate> default_gates();

/// The default gates with those of the array "gates" of a case: a gate of the same metric is overridden,
/// others follow. InputError for a gate without limit or reason, with limits that contradict, or given twice.
std::vector<Gate> load_gates(json::ObjectReader& in);

/// The gate of that metric; nullptr when there is none.
const Gate* find_gate(const std::vector<Gate>& gates, const std::string& metric);

}  // namespace orbs::registry
