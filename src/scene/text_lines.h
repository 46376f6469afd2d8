#pragma once

#include <algorithm>
#include <string_view>

namespace orbs::scene {

/// Takes the first line from the front of `text`, without what ends it: LF, CR LF, or CR alone, as programs
/// of the first Macintosh wrote it.
inline std::string_view take_line(std::string_view& text) {
  const auto line = text.substr(0, text.find_first_of("\r\n"));
  text.remove_prefix(line.size());
  text.remove_prefix(text.starts_with("\r\n") ? 2 : std::min<std::size_t>(1, text.size()));
  return line;
}

/// Takes the mark with which some editors begin a file in UTF-8.
inline void take_byte_order_mark(std::string_view& text) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
}

}  // namespace orbs::scene
