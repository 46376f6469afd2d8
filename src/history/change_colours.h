#pragma once

#include "base/terminal.h"
#include "base/text_table.h"
#include "history/change.h"

#include <string_view>
#include <vector>

namespace orbs::history {

/// The colours of the first cells of a table with a head and a row for each change: red for worse, green for
/// better. None where the style has no colour.
CellColours direction_colours(const std::vector<Change>& changes, const TerminalStyle& style);

}  // namespace orbs::history
