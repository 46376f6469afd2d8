#include "json/locate.h"

#include "json/writer.h"

#include <algorithm>
#include <atomic>

#include <nlohmann/json.hpp>
namespace orbs::json {
namespace {
std::atomic<std::size_t> stepped_over{0};
// Steps over one JSON token stream. The text is known to be valid, so no error handling.
class Scanner {
 public:
  explicit Scanner(std::string_view text, std::size_t begin = 0) : text_(text), begin_(begin), at_(begin) {}
  ~Scanner() { stepped_over += at_ - begin_; }
  Scanner(const Scanner&) = delete;
  Scanner& operator=(const Scanner&) = delete;
  std::size_t offset() {
    skip_space();
    return at_;
  }
  std::size_t offset_here() const { return at_; }  // behind what was read last
  bool consume(char c) {
    skip_space();
    if (text_[at_] != c) return false;
    ++at_;
    return true;
  }
  char peek() {
    skip_space();
    return text_[at_];
  }
  std::string string() {
    const std::size_t begin = offset();
    for (++at_; text_[at_] != '"'; ++at_)
      if (text_[at_] == '\\') ++at_;
    ++at_;
    return nlohmann::json::parse(text_.substr(begin, at_ - begin)).get<std::string>();
  }
  void value() {
    switch (peek()) {
      case '{':
        consume('{');
        if (consume('}')) return;
        do {
          string();
          consume(':');
          value();
        } while (consume(','));
        consume('}');
        return;
      case '[':
        consume('[');
        if (consume(']')) return;
        do {
          value();
        } while (consume(','));
        consume(']');
        return;
      case '"':
        string();
        return;
      default:
        at_ = std::min(text_.find_first_of(",]} \t\r\n", at_), text_.size());
    }
  }
  // Leaves the scanner at the child's value; false if there is no such child.
  bool enter(const std::string& key) {
    if (consume('{')) {
      if (peek() == '}') return false;
      do {
        const std::string name = string();
        consume(':');
        if (name == key) return true;
        value();
      } while (consume(','));
      return false;
    }
    if (consume('[')) {
      if (peek() == ']') return false;
      for (std::size_t i = 0;; ++i) {
        if (std::to_string(i) == key) return true;
        value();
        if (!consume(',')) return false;
      }
    }
    return false;
  }

 private:
  void skip_space() { at_ = std::min(text_.find_first_not_of(" \t\r\n", at_), text_.size() - 1); }
  std::string_view text_;
  std::size_t begin_;
  std::size_t at_;
};
// The parts of a JSON pointer, the last one first.
std::vector<std::string> keys_of(std::string_view pointer) {
  nlohmann::json::json_pointer p{std::string(pointer)};
  std::vector<std::string> keys;
  for (; !p.empty(); p = p.parent_pointer()) keys.push_back(p.back());
  return keys;
}
// Goes as far along the pointer as there are values; where the last of them starts.
std::size_t enter_path(Scanner& scanner, std::string_view pointer) {
  const auto keys = keys_of(pointer);
  std::size_t found = scanner.offset();
  for (auto key = keys.rbegin(); key != keys.rend() && scanner.enter(*key); ++key) found = scanner.offset();
  return found;
}
// The blanks that the line around `offset` begins with.
std::string indent_at(std::string_view text, std::size_t offset) {
  const auto begin = text.rfind('\n', offset) + 1;  // npos + 1 == 0 on the first line
  return std::string(text.substr(begin, text.find_first_not_of(" \t", begin) - begin));
}
std::string indented(std::string_view value, const std::string& indent) {
  std::string out;
  for (const char c : value) {
    out += c;
    if (c == '\n') out += indent;
  }
  return out;
}
// `text` with one more item in the array or object that begins and ends at these offsets.
std::string with_last(std::string_view text, std::size_t begin, std::size_t close, std::string_view item) {
  const auto last = text.find_last_not_of(" \t\r\n", close - 1);
  const bool is_first = last == begin;
  auto indent = indent_at(text, last);
  if (is_first) indent += "  ";
  std::string out(text.substr(0, last + 1));
  out += is_first ? "\n" : ",\n";
  out += indent + indented(item, indent);
  // What stood before the bracket stays, a line break where there was none.
  const auto before_close = text.substr(last + 1, close - last - 1);
  if (before_close.find('\n') == std::string_view::npos) {
    out += '\n';
    out += indent_at(text, begin);
  }
  out += text.substr(last + 1);
  return out;
}
}  // namespace
TextPosition position_of_offset(std::string_view text, std::size_t offset) {
  const std::string_view before = text.substr(0, offset);
  const auto line = std::count(before.begin(), before.end(), '\n');
  const std::size_t line_begin = before.rfind('\n') + 1;  // npos + 1 == 0 on the first line
  return {static_cast<int>(line) + 1, static_cast<int>(offset - line_begin) + 1};
}
TextPosition locate(std::string_view text, std::string_view pointer) {
  Scanner scanner(text);
  return position_of_offset(text, enter_path(scanner, pointer));
}
std::map<std::string, std::size_t> child_offsets(std::string_view text, std::size_t offset) {
  Scanner scanner(text, offset);
  std::map<std::string, std::size_t> offsets;
  if (scanner.consume('{')) {
    if (scanner.consume('}')) return offsets;
    do {
      const auto name = scanner.string();
      scanner.consume(':');
      offsets[name] = scanner.offset();
      scanner.value();
    } while (scanner.consume(','));
  } else if (scanner.consume('[')) {
    if (scanner.consume(']')) return offsets;
    do {
      offsets[std::to_string(offsets.size())] = scanner.offset();
      scanner.value();
    } while (scanner.consume(','));
  }
  return offsets;
}
std::size_t bytes_stepped_over() { return stepped_over; }
bool has_value(std::string_view text, std::string_view pointer) {
  Scanner scanner(text);
  const auto keys = keys_of(pointer);
  return std::all_of(keys.rbegin(), keys.rend(), [&](const auto& key) { return scanner.enter(key); });
}
std::string with_value(std::string_view text, std::string_view pointer, std::string_view value) {
  Scanner scanner(text);
  const auto begin = enter_path(scanner, pointer);
  scanner.value();
  return std::string(text.substr(0, begin)) + indented(value, indent_at(text, begin)) +
         std::string(text.substr(scanner.offset_here()));
}
std::string with_member(std::string_view text, std::string_view key, std::string_view value) {
  Scanner scanner(text);
  const auto begin = scanner.offset();
  scanner.value();
  return with_last(text, begin, scanner.offset_here() - 1, json_string(key) + ": " + std::string(value));
}
std::string with_element(std::string_view text, std::string_view array, std::string_view element) {
  Scanner scanner(text);
  const auto begin = enter_path(scanner, array);
  scanner.value();
  return with_last(text, begin, scanner.offset_here() - 1, element);
}
std::string excerpt(std::string_view text, TextPosition at) {
  std::size_t begin = 0;
  for (int line = 1; line < at.line; ++line) begin = text.find('\n', begin) + 1;
  std::string_view line = text.substr(begin, text.find('\n', begin) - begin);
  // A file may be one line of megabytes: at most this much of it on either side.
  constexpr std::size_t kSide = 100;
  const auto column = static_cast<std::size_t>(at.column - 1);
  const std::size_t left_out = column > kSide ? column - kSide : 0;
  line = line.substr(left_out, 2 * kSide);
  return std::string(line) + "\n" + std::string(column - left_out, ' ') + "^";
}
}  // namespace orbs::json
