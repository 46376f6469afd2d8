#pragma once

#include "results/run_folder.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

/// The data of a run for the page (format "orbs-page/2"). The page knows no metric, map, suite or verdict by
/// name: it shows what these data list.
namespace orbs::report {

/// The data of the overview and the charts, as columns instead of objects, so that the browser reads 10 000
/// cells in a few milliseconds: cells.case[i], cells.renderer[i], ... describe target i of the run; names are
/// indices into the lists beside them. measures.<metric>[i] is null if there is no number or if it is
/// infinite; "infinite" lists the infinite ones.
std::string overview_json(const results::RunView& view);

/// The data of one target beyond the overview: its record, its images, and the records of its renders with
/// the ends of their logs. `index` is that of run.targets.
std::string target_json(const results::RunView& view, std::size_t index);

/// The progress of a run that goes on, as an event: how many renders are done, which ones run, how many are
/// left, and the estimated seconds until the end (null if unknown).
std::string progress_json(const results::RunView& view);

/// `json` escaped for the inside of an HTML script element, so that nothing in it can end the element.
std::string script_text(std::string_view json);

}  // namespace orbs::report
