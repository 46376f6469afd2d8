#pragma once

#include <filesystem>

/// A cost study whose every number is known, for tests of the page and of the server.
namespace orbs::page_tests {

/// Three renderers, six targets, six sample counts of 4 to 4096 spp. On target 101 "orbs" has relMSE = 1e-3 /
/// t and a fixed cost of 0.05 s, so 40 dB (relMSE 1e-3) take 1.05 CPU seconds; "cycles" has 2.2e-3 / t and
/// 0.4 s, so 2.6 s; "povray" has a floor of 5e-4. Each further target has 2.5 times the variance. On the
/// third target "orbs" and "cycles" are alike. Images are 64 x 48 ramps with noise of that error.
void write_cost_study(const std::filesystem::path& folder);

/// The same a day later: another version of "orbs" takes 1.5 times the time.
void write_later_cost_study(const std::filesystem::path& folder);

}  // namespace orbs::page_tests
