#pragma once

#include <filesystem>

/// A study of stability whose every number is known, for tests of the page and of the server.
namespace orbs::page_tests {

/// Renderers "orbs" and "cycles" on the scenes "box" and "block". "orbs" follows translate_matrix to 1e9 m,
/// and rotate to the bit; "cycles" breaks on "block" at 1e4 m (mean -1.2 %) with images, and has no image on
/// "box" at 1e5 m. No scene has a ground.
void write_stability_study(const std::filesystem::path& folder);

}  // namespace orbs::page_tests
