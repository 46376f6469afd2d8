#pragma once

#include "history/change.h"
#include "history/series.h"

#include <string>
#include <vector>

namespace orbs::report {

/// The history as one HTML file that needs no server, no script and no network: steps, flaky targets, and for
/// each target its verdicts, error and time over the runs, drawn as SVG. A point says its run, date, version
/// and number where the mouse rests on it.
std::string history_page(const history::History& history, const std::vector<history::Change>& steps);

}  // namespace orbs::report
