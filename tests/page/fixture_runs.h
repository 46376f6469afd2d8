#pragma once

#include <filesystem>

/// Folders of runs whose every number is known, for tests of the page and of the server.
namespace orbs::page_tests {

/// Two suites, three renderers, every verdict. Images of m1_values by "one" are 64 x 48: the result is
/// (x / 64, y / 48, 0.25), the reference the same but 1 more in R at (40, 20), 0.5 more in G at (10, 30); the
/// result is NaN at (5, 7), infinite at (6, 7), 70000 at (8, 9), -0.5 at (9, 9), all in R. Its maps are "l1",
/// "signed" and "wobble", of which nobody has heard. a1_stokes has layers S0 to S3. e1_markup is full of
/// markup.
void write_small_run(const std::filesystem::path& folder);

/// As the small run, but "two" failed m1_values, "one" passed e1_markup, m9_new is not there and g9_gone is.
void write_earlier_run(const std::filesystem::path& folder);

/// 1000 images by 10 renderers, without files of images.
void write_run_of_many_cells(const std::filesystem::path& folder);

/// One image of 4096 x 4096 and its reference, which differ in the square from (4000, 4000) to (4010,
/// 4010).
void write_run_of_huge_images(const std::filesystem::path& folder);

/// A run of three renders that ends one with each line on stdin.
void play_live_run(const std::filesystem::path& folder);

}  // namespace orbs::page_tests
