#pragma once
#include <cstddef>
#include <string>
#include <string_view>
namespace orbs::json {
struct TextPosition {
  int line = 1;
  int column = 1;
};  // 1-based, column in bytes
TextPosition position_of_offset(std::string_view text, std::size_t offset);
/// Where the value with this JSON pointer starts in `text`. `text` must be valid JSON.
/// Only used to write error messages, so it rescans from the start (cost: one pass).
TextPosition locate(std::string_view text, std::string_view pointer);
/// The line of `text` holding `at`, and a caret line under the column.
std::string excerpt(std::string_view text, TextPosition at);
}  // namespace orbs::json
