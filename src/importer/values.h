#pragma once

#include "importer/library.h"

#include <optional>
#include <string>
#include <vector>

/// Numbers in the objects of extensions, which the library keeps as they stand.
namespace orbs::importer {

/// The number under `key`; nothing if there is none.
std::optional<double> number_in(const tinygltf::Value& object, const std::string& key);

/// The numbers under `key`, as many as `otherwise` has, which stands for them if they are not there.
std::vector<double> numbers_in(const tinygltf::Value& object,
                               const std::string& key,
                               const std::vector<double>& otherwise);

}  // namespace orbs::importer
