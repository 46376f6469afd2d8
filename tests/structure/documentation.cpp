#include "structure/documentation.h"

#include "base/files.h"
#include "base/text.h"
#include "structure/source_files.h"

#include <cctype>
#include <cstdlib>
#include <map>
#include <regex>
#include <sstream>
#include <utility>

#include <fmt/format.h>

namespace orbs::structure {

namespace {

// 0 for a line that is no heading.
std::size_t heading_level(const std::string& line) {
  const auto level = line.find_first_not_of('#');
  return level != std::string::npos && level > 0 && level <= 6 && line[level] == ' ' ? level : 0;
}

void add_links(const std::string& line, std::size_t number, Page& page) {
  static const std::regex link(R"(\]\(([^)\s]+)\))");
  // Inline code shows how something is written; it does not link.
  static const std::regex code(R"(`[^`]*`)");
  const auto text = std::regex_replace(line, code, "");
  for (auto at = std::sregex_iterator(text.begin(), text.end(), link); at != std::sregex_iterator(); ++at)
    page.links.push_back({number, (*at)[1].str()});
}

void add_anchor(const std::string& line, std::map<std::string, int>& seen, Page& page) {
  const auto anchor = anchor_of(line.substr(heading_level(line) + 1));
  const int earlier = seen[anchor]++;
  page.anchors.insert(earlier == 0 ? anchor : fmt::format("{}-{}", anchor, earlier));
}

struct Markers {
  std::string begin;
  std::string end;
};

Markers markers_of(const std::string& name) {
  return {fmt::format("<!-- generated: {} -->\n", name), fmt::format("<!-- end of {} -->", name)};
}

// Where the part begins and ends; npos for both when a marker is missing.
std::pair<std::size_t, std::size_t> place_of_part(const std::string& text, const std::string& name) {
  const auto [begin, end] = markers_of(name);
  const auto from = text.find(begin);
  const auto to = from == std::string::npos ? from : text.find(end, from);
  if (to == std::string::npos) return {std::string::npos, std::string::npos};
  return {from + begin.size(), to};
}

}  // namespace

Page read_page(const std::filesystem::path& file) {
  Page page{file, lines_of(file), {}, {}, {}, 0};
  std::map<std::string, int> seen;
  bool is_code = false;
  std::string language;
  for (std::size_t i = 0; i < page.lines.size(); ++i) {
    const auto& line = page.lines[i];
    const auto text = trim(line);  // blocks of list items are indented
    if (text.starts_with("```")) {
      is_code = !is_code;
      page.open_block = is_code ? i + 1 : 0;
      language = text.substr(3);
    } else if (is_code) {
      page.code.push_back({i + 1, language, line});
    } else {
      if (heading_level(line) > 0) add_anchor(line, seen, page);
      add_links(line, i + 1, page);
    }
  }
  return page;
}

std::vector<Page> pages_below(const std::filesystem::path& root) {
  std::vector<Page> pages;
  for (const auto& file : files_below(root, {".md"})) pages.push_back(read_page(file));
  return pages;
}

std::string anchor_of(const std::string& heading) {
  std::string anchor;
  for (const char c : trim(heading)) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == ' ')
      anchor += '-';
    else if (c == '-' || c == '_' || byte >= 0x80U || std::isalnum(byte) != 0)
      anchor += static_cast<char>(std::tolower(byte));
  }
  return anchor;
}

std::vector<std::string> section(const Page& page, const std::string& heading) {
  const auto level = heading_level(heading);
  std::vector<std::string> out;
  bool is_inside = false;
  for (const auto& line : page.lines) {
    const auto here = heading_level(line);
    if (is_inside && here > 0 && here <= level) break;
    if (is_inside) out.push_back(line);
    if (line == heading) is_inside = true;
  }
  return out;
}

std::string check_generated_part(const std::filesystem::path& file,
                                 const std::string& name,
                                 const std::string& expected) {
  const auto text = read_file(file);
  const auto [from, to] = place_of_part(text, name);
  if (from == std::string::npos) return fmt::format("{} has no generated part '{}'", file.string(), name);
  if (text.substr(from, to - from) == expected) return "";
  if (std::getenv("ORBS_WRITE_DOCUMENTATION") == nullptr)
    return fmt::format("the part '{}' of {} is out of date: run this test with ORBS_WRITE_DOCUMENTATION=1",
                       name, file.string());
  write_file(file, text.substr(0, from) + expected + text.substr(to));
  return "";
}

std::string wrapped(const std::string& text, std::size_t width) {
  std::istringstream words(text);
  std::string out;
  std::size_t length = 0;  // of the last line
  for (std::string word; words >> word;) {
    if (length > 0 && length + 1 + word.size() > width) {
      out += '\n';
      length = 0;
    } else if (length > 0) {
      out += ' ';
      ++length;
    }
    out += word;
    length += word.size();
  }
  return out;
}

}  // namespace orbs::structure
