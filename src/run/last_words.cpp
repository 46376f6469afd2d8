#include "run/last_words.h"

#include "base/pattern.h"
#include "base/text.h"
#include "run/named_within.h"

#include <algorithm>
#include <vector>

namespace orbs::run {

namespace {

// ESC [ ... and a last byte from @ to ~ (ECMA-48, 5.4), which set colours.
std::string without_escapes(const std::string& text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool is_sequence = text[i] == '\x1b' && i + 1 < text.size() && text[i + 1] == '[';
    if (!is_sequence) {
      out += text[i];
      continue;
    }
    i += 2;
    while (i < text.size() && (text[i] < '@' || text[i] > '~')) ++i;
  }
  return out;
}

// A carriage return starts a line anew.
std::vector<std::string> lines_with_text(const std::string& output) {
  std::vector<std::string> lines;
  for (const auto& line : split(output, '\n'))
    for (const auto& part : split(without_escapes(line), '\r'))
      if (const auto text = trim(part); !text.empty()) lines.emplace_back(text);
  return lines;
}

bool names_error(const std::string& line) {
  static const Pattern kError("([Ee]rror|ERROR|[Ee]xception|[Ff]atal|FATAL)[^:]*: *[^ ]");
  return !kError.last_match(line).empty();
}

// At most `most` bytes, no character cut in two.
std::string shortened(std::string text, std::size_t most) {
  if (text.size() <= most) return text;
  while (most > 0 && (static_cast<unsigned char>(text[most]) & 0xc0U) == 0x80U) --most;
  text.resize(most);
  return text;
}

}  // namespace

std::string last_words(const std::string& output, const std::filesystem::path& folder) {
  constexpr std::size_t kMost_bytes = 200;
  constexpr std::ptrdiff_t kLastLines = 12;
  const auto lines = lines_with_text(output);
  if (lines.empty()) return "";
  const auto last = lines.end() - std::min<std::ptrdiff_t>(kLastLines, std::ssize(lines));
  const auto error = std::find_if(last, lines.end(), names_error);
  return shortened(clean_text(named_within(folder, error == lines.end() ? lines.back() : *error)),
                   kMost_bytes);
}

}  // namespace orbs::run
