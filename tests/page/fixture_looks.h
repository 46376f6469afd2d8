#pragma once

#include <filesystem>

/// Folders of runs whose renders are made in looks, for tests of the page.
namespace orbs::page_tests {

/// The scene "lamp" by "one" passes at its third look, at 64 samples, in 1.2 s; the first look sees
/// edge_blur, the others mean_ratio_g. By "two" it is at the edge of mean_ratio_g after nine looks, at 4096
/// samples. By "three" its samples were fixed. The scene "mirror" fails at its first look by "one", of which
/// only one end of the interval is known. By "two" four gates occur, and the error rates allow no further
/// look. By "three" no gate has a number.
void write_run_of_looks(const std::filesystem::path& folder);

/// A run of two renders that goes on: each of three lines on stdin is a look at the first one, at 16, 32 and
/// 64 samples. The last one passes.
void play_live_looks(const std::filesystem::path& folder);

}  // namespace orbs::page_tests
