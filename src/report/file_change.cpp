#include "report/file_change.h"

#include "json/field_writer.h"
#include "json/writer.h"

#include <algorithm>
#include <cstddef>
#include <string_view>
#include <vector>

#include <fmt/format.h>

namespace orbs::report {

namespace {

using Lines = std::vector<std::string_view>;

// Each with the end that it has.
Lines lines_of(std::string_view text) {
  Lines lines;
  while (!text.empty()) {
    const auto length = std::min(text.find('\n'), text.size() - 1) + 1;
    lines.push_back(text.substr(0, length));
    text.remove_prefix(length);
  }
  return lines;
}

void add_lines(std::string& out, char mark, const Lines& lines, std::size_t begin, std::size_t end) {
  for (auto i = begin; i < end; ++i) {
    out += mark;
    out += lines[i];
    if (!lines[i].ends_with('\n')) out += "\n\\ No newline at end of file\n";
  }
}

// "12,7", and "12" for one line. Of none, diff names the line before.
std::string range_text(std::size_t begin, std::size_t end) {
  const auto first = end > begin ? begin + 1 : begin;
  return end - begin == 1 ? fmt::format("{}", first) : fmt::format("{},{}", first, end - begin);
}

}  // namespace

std::string unified_diff(const std::string& before, const std::string& after, const std::string& name) {
  if (before == after) return "";
  constexpr std::size_t kContext = 3;
  const auto old_lines = lines_of(before);
  const auto new_lines = lines_of(after);
  const auto shorter = std::min(old_lines.size(), new_lines.size());
  std::size_t same = 0;  // lines before the change
  while (same < shorter && old_lines[same] == new_lines[same]) ++same;
  std::size_t rest = 0;  // lines after it
  while (rest < shorter - same && *(old_lines.rbegin() + static_cast<std::ptrdiff_t>(rest)) ==
                                      *(new_lines.rbegin() + static_cast<std::ptrdiff_t>(rest)))
    ++rest;
  const auto begin = same - std::min(same, kContext);
  const auto shown = std::min(rest, kContext);
  const auto old_end = old_lines.size() - rest;
  const auto new_end = new_lines.size() - rest;
  auto out = fmt::format("--- {}\n+++ {}\n@@ -{} +{} @@\n", name, name, range_text(begin, old_end + shown),
                         range_text(begin, new_end + shown));
  add_lines(out, ' ', old_lines, begin, same);
  add_lines(out, '-', old_lines, same, old_end);
  add_lines(out, '+', new_lines, same, new_end);
  add_lines(out, ' ', old_lines, old_end, old_end + shown);
  return out;
}

std::string file_change_json(const FileChange& change) {
  json::Writer out;
  json::write_record(out, change);
  return out.text();
}

}  // namespace orbs::report
