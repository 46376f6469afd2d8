#pragma once

#include "results/run_folder.h"

#include <string>

/// The data of a run for the page (format "orbs-page/2"). The page knows no metric, map, suite or verdict by
/// name: it shows what these data list.
namespace orbs::report {

/// The data of the overview and the charts, as columns instead of objects, so that the browser reads 10 000
/// cells in a few milliseconds: cells.case[i], cells.renderer[i], ... describe target i of the run; names are
/// indices into the lists beside them. measures.<metric>[i] is null if there is no number or if it is
/// infinite; "infinite" lists the infinite ones.
std::string overview_json(const results::RunView& view);

}  // namespace orbs::report
