#include "scene/geometry/ply_header.h"

#include "base/error.h"
#include "base/text.h"
#include "scene/text_lines.h"

#include <algorithm>
#include <map>
#include <optional>

#include <fmt/format.h>

namespace orbs::scene {

std::size_t ply_bytes_of(const std::string& type) {
  static const std::map<std::string, std::size_t> sizes{
      {"char", 1},  {"uchar", 1},   {"int8", 1},   {"uint8", 1},  {"short", 2}, {"ushort", 2},
      {"int16", 2}, {"uint16", 2},  {"int", 4},    {"uint", 4},   {"int32", 4}, {"uint32", 4},
      {"float", 4}, {"float32", 4}, {"double", 8}, {"float64", 8}};
  const auto found = sizes.find(type);
  return found == sizes.end() ? 0 : found->second;
}

bool has_property(const PlyElement& element, std::string_view name) {
  return std::any_of(element.properties.begin(), element.properties.end(),
                     [&](const PlyProperty& property) { return property.name == name; });
}

namespace {

class HeaderReader {
 public:
  HeaderReader(const std::string& name, std::string_view bytes)
      : name_(name), bytes_(bytes), rest_(bytes), ends_with_cr_(ends_with_cr(bytes)) {}

  PlyHeader read() {
    if (line() != "ply") fail("the file does not start with 'ply'");
    for (auto text = line(); text != "end_header"; text = line()) read_words(words_of(text));
    if (!encoding_) fail("the header names no format");
    // Without this check a row would take no byte, and a short file could claim more rows than can be read in
    // a lifetime.
    for (const auto& element : elements_)
      if (element.properties.empty()) fail(fmt::format("element '{}' has no property", element.name));
    return {*encoding_, std::move(elements_), bytes_.size() - rest_.size()};
  }

 private:
  // Of CR alone. A byte of LF after the header is then the first of binary data.
  static bool ends_with_cr(std::string_view bytes) {
    auto rest = bytes;
    take_line(rest);
    return !bytes.substr(0, bytes.size() - rest.size()).ends_with('\n');
  }

  std::string_view line() {
    const auto end = rest_.find(ends_with_cr_ ? '\r' : '\n');
    ++line_;
    if (end == std::string_view::npos) fail("the header has no end_header");
    const auto text = trim(rest_.substr(0, end));
    rest_.remove_prefix(end + 1);
    return text;
  }

  void read_words(const std::vector<std::string>& words) {
    if (words.empty() || words[0] == "comment" || words[0] == "obj_info") return;
    if (words[0] == "format" && words.size() == 3)
      read_format(words[1]);
    else if (words[0] == "element" && words.size() == 3)
      read_element(words[1], words[2]);
    else if (words[0] == "property" && !elements_.empty() &&
             (words.size() == 3 || (words.size() == 5 && words[1] == "list")))
      read_property(words);
    else
      fail(fmt::format("header line that starts with '{}' is not understood", words[0]));
  }

  void read_format(const std::string& format) {
    static const std::map<std::string, PlyEncoding> kEncodings{
        {"ascii", PlyEncoding::Ascii},
        {"binary_little_endian", PlyEncoding::LittleEndian},
        {"binary_big_endian", PlyEncoding::BigEndian}};
    const auto found = kEncodings.find(format);
    if (found == kEncodings.end())
      fail(fmt::format("format {} is not supported: use ascii, binary_little_endian or binary_big_endian",
                       format));
    encoding_ = found->second;
  }

  void read_element(const std::string& element, const std::string& rows) {
    const auto count = to_integer(rows);
    // A row takes at least one byte, so a count larger than the file is wrong and must not allocate memory.
    if (!count || *count < 0 || static_cast<std::size_t>(*count) > bytes_.size())
      fail(fmt::format("element count '{}' is impossible", rows));
    elements_.push_back({element, static_cast<std::size_t>(*count), {}});
  }

  void read_property(const std::vector<std::string>& words) {
    const bool is_list = words.size() == 5;
    for (std::size_t i = is_list ? 2 : 1; i + 1 < words.size(); ++i)
      if (ply_bytes_of(words[i]) == 0) fail(fmt::format("property type '{}' is unknown", words[i]));
    elements_.back().properties.push_back({words.back(), words[words.size() - 2], is_list ? words[2] : ""});
  }

  [[noreturn]] void fail(const std::string& problem) const {
    throw InputError(fmt::format("{}:{}: {}", name_, line_, problem));
  }

  const std::string& name_;
  std::string_view bytes_;
  std::string_view rest_;
  bool ends_with_cr_;
  int line_ = 0;
  std::optional<PlyEncoding> encoding_;
  std::vector<PlyElement> elements_;
};

}  // namespace

PlyHeader parse_ply_header(const std::string& name, std::string_view bytes) {
  return HeaderReader(name, bytes).read();
}

}  // namespace orbs::scene
