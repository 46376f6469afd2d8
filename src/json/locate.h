#pragma once
#include <cstddef>
#include <map>
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
/// Where the members of the object, or the elements of the array, that starts at `offset` start themselves:
/// by key, or by number ("0", "1", ...). None of any other value.
std::map<std::string, std::size_t> child_offsets(std::string_view text, std::size_t offset);
/// Bytes of all texts that the functions here have stepped over since the program started: what tests count
/// to see that a reader does not step over the same text again and again.
std::size_t bytes_stepped_over();
/// `text` with one more element, itself JSON, at the end of the array with this JSON pointer: on lines of its
/// own, indented like the element before it. Every other byte stays. `text` must be valid JSON and hold the
/// array.
std::string with_element(std::string_view text, std::string_view array, std::string_view element);
/// Whether there is a value with this JSON pointer in `text`, which must be valid JSON.
bool has_value(std::string_view text, std::string_view pointer);
/// `text` with another value, itself JSON, instead of the one with this JSON pointer. Every other byte
/// stays. `text` must be valid JSON and hold the value.
std::string with_value(std::string_view text, std::string_view pointer, std::string_view value);
/// `text`, an object in valid JSON, with one more member at its end, on separate lines and indented like
/// the member before it. Every other byte stays.
std::string with_member(std::string_view text, std::string_view key, std::string_view value);
/// The line of `text` holding `at`, of a long one what is near, and a caret line under the column.
std::string excerpt(std::string_view text, TextPosition at);
}  // namespace orbs::json
