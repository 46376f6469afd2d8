#pragma once

#include "results/record.h"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

/// What orbs effects has found (format "orbs-prices/1"), as far as runs repeat it.
namespace orbs::results {

/// Beside the references of the suite.
inline constexpr const char* kPricesFile = "prices.json";

/// By scene; nothing when there is no file. InputError with file, line and key.
std::map<std::string, std::vector<PriceRecord>> read_prices(const std::filesystem::path& file);

}  // namespace orbs::results
