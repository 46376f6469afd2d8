#include "base/terminal.h"

#include "base/text.h"

#include <algorithm>
#include <array>
#include <cstdlib>

#include <sys/ioctl.h>
#include <unistd.h>

namespace orbs {

namespace {

constexpr std::array kColours{colour::kGreen, colour::kRed, colour::kYellow, colour::kFaint, colour::kNone};

// Length of the colour that starts the text, 0 when there is none.
std::size_t colour_length(std::string_view text) {
  for (const auto colour : kColours)
    if (text.starts_with(colour)) return colour.size();
  return 0;
}

}  // namespace

std::string terminal_text(std::string_view text) {
  std::string out;
  std::size_t from = 0;
  for (auto at = text.find('\x1b'); at != std::string_view::npos; at = text.find('\x1b', at + 1)) {
    const auto length = colour_length(text.substr(at));
    if (length == 0) continue;
    out += clean_text(text.substr(from, at - from));
    out += text.substr(at, length);
    from = at + length;
  }
  return out + clean_text(text.substr(from));
}

void print_raw(std::FILE* file, std::string_view text) { fmt::print(file, "{}", text); }

int terminal_width(int descriptor) {
  constexpr int kLeast = 20;
  if (const char* columns = std::getenv("COLUMNS"); columns != nullptr)
    if (const auto number = to_integer(columns); number && *number >= kLeast && *number <= 10000)
      return static_cast<int>(*number);
  winsize size{};
  if (::isatty(descriptor) != 1 || ::ioctl(descriptor, TIOCGWINSZ, &size) != 0) return 0;
  return std::max<int>(size.ws_col, size.ws_col == 0 ? 0 : kLeast);
}

TerminalStyle terminal_style(int descriptor) {
  const char* no_colour = std::getenv("NO_COLOR");
  const char* terminal = std::getenv("TERM");
  const bool wanted = no_colour == nullptr || *no_colour == '\0';
  const bool able = ::isatty(descriptor) == 1 && terminal != nullptr && std::string_view(terminal) != "dumb";
  return {wanted && able, terminal_width(descriptor)};
}

std::string painted(std::string_view text, std::string_view colour, const TerminalStyle& style) {
  if (!style.colour || colour.empty()) return std::string(text);
  return std::string(colour) + std::string(text) + std::string(colour::kNone);
}

}  // namespace orbs
