#pragma once

#include "base/terminal.h"
#include "studies/cost/change.h"

#include <string>

/// The comparison of two studies of cost, for people and programs.
namespace orbs::studies {

/// The factor of each renderer, the scenes that changed, and what was not compared.
std::string changes_text(const CostChanges& changes, const TerminalStyle& style);

/// The same for a pull request, at every error.
std::string changes_markdown(const CostChanges& changes);

/// The same for programs and the page (format "orbs-cost-changes/1").
std::string changes_json(const CostChanges& changes);

}  // namespace orbs::studies
