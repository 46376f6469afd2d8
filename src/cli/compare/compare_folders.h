#pragma once

#include "cli/compare/compare_images.h"

namespace orbs::cli {

/// orbs compare of two folders: prints a table of the images of the same names, the worst first, and names
/// those that only one of the two has. Returns the exit status. InputError where there is no image at all.
int compare_folders(const CompareOptions& given);

}  // namespace orbs::cli
