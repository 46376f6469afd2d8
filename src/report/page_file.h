#pragma once

#include "results/run_folder.h"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// The parts of a one-file page: the built page, and the script elements that hold its data.

namespace orbs::report {

/// The contents of a file in the folder of a run or study. InputError if it does not lie in the folder:
/// the names in the JSON are not trusted.
std::string file_of(const std::filesystem::path& folder, const std::string& name);

struct EmbeddedImages {
  std::string elements;  // script elements, and "orbs-images", which says which file became which
  std::size_t count = 0;
  std::vector<std::string> left_out;  // those for which there was no room, and why others cannot be read
};

/// Makes elements of images while there is room, in the order of `files`, each once. `content` makes the
/// bytes of a file that stand in an element of `type`; a file for which it throws InputError is left out with
/// the reason.
EmbeddedImages embed_images(const std::vector<std::string>& files,
                            const std::string& type,
                            const std::function<std::string(const std::string&)>& content,
                            std::size_t most_bytes);

/// The built page before and after the place of its data. InputError when the page is not built.
std::pair<std::string, std::string> page_template(const std::filesystem::path& bundle);

/// `json` escaped for the inside of an HTML script element, so that nothing in it can end the element.
std::string script_text(std::string_view json);

/// A script element that the browser does not run. `content` holds no '<'.
std::string data_element(const std::string& id, const std::string& type, const std::string& content);

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
