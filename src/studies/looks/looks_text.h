#pragma once

#include "studies/looks/simulate_looks.h"

#include <string>
#include <vector>

namespace orbs::studies {

/// The rows as a table with the ends of the 95 % intervals (Wilson 1927), for people.
std::string looks_text(const std::vector<LooksRow>& rows);

/// Likewise as CSV, and back. InputError for text of another form.
std::string looks_csv(const std::vector<LooksRow>& rows);
std::vector<LooksRow> read_looks_csv(const std::string& text);

}  // namespace orbs::studies
