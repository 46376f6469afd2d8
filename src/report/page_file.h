#pragma once

#include "results/run_folder.h"

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace orbs::report {

struct PageFileSettings {
  std::filesystem::path bundle;          // folder of the built page
  std::size_t most_bytes = 100'000'000;  // of the images in the file
  bool exact = false;                    // images as they are, not rounded to half floats
};

struct PageFile {
  std::string text;
  std::size_t images = 0;             // packed into the file
  std::vector<std::string> left_out;  // images for which there was no room, and such that cannot be read
};

/// The page and all it shows as one HTML file that needs no server and asks no network. While there is room,
/// images are taken in this order: results and references of what failed, those of the rest, then maps that a
/// run of an earlier version left. InputError when the page is not built.
PageFile page_file(const results::RunView& view, const PageFileSettings& settings);

/// The page of the study in `folder`: its file as it is, and its images as PNG while there is room, in the
/// order of results::StudyKind::images. InputError when the page is not built or the folder holds no study.
/// settings.exact has no meaning here.
PageFile study_page_file(const std::filesystem::path& folder, const PageFileSettings& settings);

}  // namespace orbs::report
