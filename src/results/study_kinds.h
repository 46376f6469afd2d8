#pragma once

#include "json/fields.h"

#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace orbs::json {
class ObjectReader;
}

/// The kinds of studies, as the command line, the server and the one-file page see their folders. The page
/// reads the file of a study as it is. A new kind is a row here, and its view in web/src/studies.tsx.
namespace orbs::results {

struct StudyKind {
  std::string_view name;    // of the kind on the page, and the start of the names of its folders
  std::string_view file;    // in the folder of a study
  std::string_view format;  // that the file states
  /// Files of the images that the study names, relative to its folder, the most useful ones first.
  std::vector<std::string> (*images)(json::ObjectReader& root);
};

/// References, then the last setting of every curve, then the ones before.
std::vector<std::string> cost_images(json::ObjectReader& root);
/// The images of each step that kept some.
std::vector<std::string> stability_images(json::ObjectReader& root);

inline constexpr StudyKind kCost{"cost", "cost.json", "orbs-cost/2", cost_images};
inline constexpr StudyKind kStability{"stability", "stability.json", "orbs-stability/1", stability_images};
inline constexpr std::array kStudyKinds{kCost, kStability};

/// The kind whose file lies in the folder; null if there is none.
const StudyKind* study_kind_in(const std::filesystem::path& folder);

struct StudyFolder {
  StudyKind kind;
  std::string started;
  std::vector<std::string> images;  // relative to the folder
};

/// InputError if the folder holds no study, or its file is broken or of another format.
StudyFolder read_study_folder(const std::filesystem::path& folder);

/// What lies in the folder of each step of a study of stability that kept images.
inline constexpr const char* kOriginalImage = "original.png";
inline constexpr const char* kChangedImage = "changed.png";
inline constexpr const char* kDifferenceImage = "difference.png";

/// What a number of a study means, for readers outside this program.
struct Definition {
  std::string_view name;
  std::string_view text;
};

template <class Visitor, json::RecordOf<Definition> Record>
void fields(Visitor& visit, Record& definition) {
  visit("name", definition.name);
  visit("text", definition.text);
}

}  // namespace orbs::results
