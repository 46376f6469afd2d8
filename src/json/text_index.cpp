#include "json/text_index.h"

#include <algorithm>

#include <nlohmann/json.hpp>

namespace orbs::json {

const std::map<std::string, std::size_t>& TextIndex::children_of(std::string_view text,
                                                                 const std::string& pointer,
                                                                 std::size_t offset) {
  const auto [entry, is_new] = children_.try_emplace(pointer);
  if (is_new) entry->second = child_offsets(text, offset);
  return entry->second;
}

TextPosition TextIndex::locate(std::string_view text, std::string_view pointer) {
  if (line_begins_.empty()) {
    line_begins_.push_back(0);
    for (std::size_t i = 0; i < text.size(); ++i)
      if (text[i] == '\n') line_begins_.push_back(i + 1);
  }
  // nlohmann unescapes the parts of the pointer, and gives the last one first.
  std::vector<std::string> pointers;
  std::vector<std::string> keys;
  for (nlohmann::json::json_pointer left{std::string(pointer)}; !left.empty(); left = left.parent_pointer()) {
    keys.push_back(left.back());
    pointers.push_back(left.parent_pointer().to_string());
  }
  std::size_t offset = text.find_first_not_of(" \t\r\n");
  for (std::size_t i = keys.size(); i-- > 0;) {
    const auto& children = children_of(text, pointers[i], offset);
    const auto child = children.find(keys[i]);
    if (child == children.end()) break;
    offset = child->second;
  }
  const auto line = std::upper_bound(line_begins_.begin(), line_begins_.end(), offset) - 1;
  return {static_cast<int>(line - line_begins_.begin()) + 1, static_cast<int>(offset - *line) + 1};
}

}  // namespace orbs::json
