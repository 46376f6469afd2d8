#pragma once

#include "json/text_index.h"

#include <filesystem>
#include <memory>
#include <string>

#include <nlohmann/json_fwd.hpp>

namespace orbs::json {

struct Layers;

/// A parsed text that remembers its name, so that every later complaint can say file, line and column. One
/// thread reads it at a time.
struct Document {
  std::string name;
  std::string text;
  std::shared_ptr<const nlohmann::json> root;
  std::shared_ptr<TextIndex> index;        // of the text
  std::shared_ptr<const Layers> layers{};  // that it was put together from; none for the text of one file
};

/// InputError with line, column and excerpt on syntax errors, on a key given twice and on nesting beyond 64
/// levels.
Document parse(std::string name, std::string text);
Document parse_file(const std::filesystem::path& path);

}  // namespace orbs::json
