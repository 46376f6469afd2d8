#pragma once

#include "report/page_file.h"

namespace orbs::report {

/// The page of the study of stability in `folder` as one HTML file: stability.json as it is, and the images
/// of first breaks while there is room. InputError when the page is not built or the folder holds no study.
/// settings.exact has no meaning here.
PageFile stability_page_file(const std::filesystem::path& folder, const PageFileSettings& settings);

}  // namespace orbs::report
