#pragma once

#include <CLI/CLI.hpp>

namespace orbs::cli {

/// Checks of options that any finite number, or one above 0 or from 0, may follow. CLI11's own tell the range
/// up to the largest double, by all of its 309 digits, and let "nan" pass.
CLI::Validator any_number();
CLI::Validator above_zero();
CLI::Validator zero_or_more();

}  // namespace orbs::cli
