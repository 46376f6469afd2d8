#pragma once

#include "json/writer.h"

#include <optional>
#include <vector>

namespace orbs::studies {

/// The middle of some measurements and the ends between which all of them lie.
struct Spread {
  double median = 0;  // of an even number: the mean of the two in the middle
  double least = 0;
  double most = 0;
};

/// Nothing when there are no values.
std::optional<Spread> spread_of(std::vector<double> values);

/// As the member `name` of an object; null for nothing.
void write_spread(json::Writer& out, const char* name, const std::optional<Spread>& spread);

}  // namespace orbs::studies
