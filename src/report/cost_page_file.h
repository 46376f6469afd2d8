#pragma once

#include "report/page_file.h"

namespace orbs::report {

/// The page of the cost study in `folder` as one HTML file: cost.json as it is, and its images as PNG while
/// there is room: the references, then the last rung of every curve, then the rungs before. InputError when
/// the page is not built or the folder holds no study. settings.exact has no meaning here.
PageFile cost_page_file(const std::filesystem::path& folder, const PageFileSettings& settings);

}  // namespace orbs::report
