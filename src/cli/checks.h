#pragma once

#include <string>

#include <CLI/CLI.hpp>

/// Checks of options.
namespace orbs::cli {

/// Refuses the empty text, which would count as an option that is not given. `what` is what the option
/// needs: "a folder".
CLI::Validator not_empty(const std::string& what);

/// Accept any finite number, one above 0, or one from 0 up. CLI11's own checks print the range up to the
/// largest double, with all of its 309 digits, and let "nan" pass.
CLI::Validator any_number();
CLI::Validator above_zero();
CLI::Validator zero_or_more();

}  // namespace orbs::cli
