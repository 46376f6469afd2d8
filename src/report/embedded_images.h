#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

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

}  // namespace orbs::report
