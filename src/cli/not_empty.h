#pragma once

#include <CLI/CLI.hpp>

namespace orbs::cli {

/// Check of an option whose empty value would count as one that is not given: `what` it needs, "a folder".
CLI::Validator not_empty(const std::string& what);

}  // namespace orbs::cli
