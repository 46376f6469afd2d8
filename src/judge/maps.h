#pragma once

#include "image/image.h"
#include "metrics/compare.h"
#include "results/record.h"

#include <filesystem>
#include <vector>

namespace orbs::judge {

/// Writes result.png and the error maps as error-<name>.exr and .png (with a colour scale) into `folder`.
/// Returns the maps; their files are relative to `folder`.
std::vector<results::MapRecord> write_maps(const image::Image& result,
                                           const metrics::Comparison& comparison,
                                           const std::filesystem::path& folder);

}  // namespace orbs::judge
