#pragma once

#include "json/document.h"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

/// The files that a configuration is put together from.
namespace orbs::registry {

struct ConfigurationFiles {
  std::vector<std::filesystem::path> layers;  // the lowest first; each is over those before it
  std::filesystem::path data{};               // {data}; "": the folder data beside the lowest file
};

/// A file that is read as this text, which it does not hold yet.
struct EditedFile {
  std::filesystem::path file;
  std::string text;
};

/// All of them as one document, with those that they include below them and without what lies below a file
/// that stands alone.
struct LayeredFiles {
  json::Document document;
  std::vector<std::filesystem::path> files;  // the lowest first; absolute
  std::filesystem::path root;                // the folder of the lowest that no other includes
};

/// {root} and {data} of files in other folders, and their relative paths, are put in their place. InputError
/// with file and line for a file that is none, that includes itself, or that holds a name twice.
LayeredFiles read_layers(const ConfigurationFiles& files, const std::optional<EditedFile>& edited);

/// "renderers/cycles/seeds" and "configuration.json:7".
struct ValuePlace {
  std::string value;
  std::string place;
};

/// Where each setting of each entry comes from, in the order of the whole.
std::vector<ValuePlace> value_places(const ConfigurationFiles& files);

/// What a file of one's own begins as.
inline constexpr const char* kEmptyConfiguration = "{\n  \"format\": \"orbs-configuration/1\"\n}\n";

/// The text of a file of one's own; kEmptyConfiguration if there is no such file yet. InputError where ""
/// says that the user has no folder for one.
std::string own_text(const std::filesystem::path& file);

/// Writes it, through a symbolic link, which stays one; makes its folder. WriteError when the disk refuses.
void write_own(const std::filesystem::path& file, const std::string& text);

/// `files` with `file` on top, unless it is among them.
ConfigurationFiles with_own(ConfigurationFiles files, const std::filesystem::path& file);

}  // namespace orbs::registry
