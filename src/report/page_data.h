#pragma once

#include "results/run_folder.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

/// A run as the page reads it (format "orbs-page/2"). The page knows no metric, map, suite or verdict by
/// name: all that it shows stands here.
namespace orbs::report {

/// All that the overview and the charts show, columns instead of objects so that 10 000 cells are read in a
/// few milliseconds: cells.case[i], cells.renderer[i], ... describe image i of the run; names are indices
/// into the lists beside them. measures.<metric>[i] is null where there is no number and where it is
/// infinite, which "infinite" lists.
std::string overview_json(const results::RunView& view);

/// What the page needs to know about one image beyond the overview: the record, its renders with their
/// commands and the ends of their logs, its images. `index` is of run.targets.
std::string target_json(const results::RunView& view, std::size_t index);

/// How many renders are done, which ones run, how many are left, and the estimate of what that takes in
/// seconds (null where there is none): an event of a run that goes on.
std::string progress_json(const results::RunView& view);

/// `json` for the inside of an HTML script element: nothing in it can end the element.
std::string script_text(std::string_view json);

}  // namespace orbs::report
