#include "cli/shown_commands.h"

#include "base/text.h"
#include "structure/documentation.h"

#include <cctype>
#include <filesystem>
#include <regex>

#include <fmt/format.h>

namespace orbs::cli_tests {

namespace {

const std::filesystem::path kRoot = ORBS_SOURCE_DIR;

// "orbs …" of a line that may name the program's path; "" of another line. Where output is shown, too,
// commands stand behind a prompt.
std::string command_of(const structure::CodeLine& line, const std::string& text) {
  static const std::regex bare(R"(^\s*(\$ )?(\S*/)?orbs(?= ))");
  static const std::regex behind_prompt(R"(^\s*\$ (\S*/)?orbs(?= ))");
  std::smatch match;
  if (!std::regex_search(text, match, line.language == "sh" ? bare : behind_prompt)) return {};
  return "orbs" + match.suffix().str();
}

void add_of_blocks(const structure::Page& page, const std::string& name, std::vector<ShownCommand>& out) {
  for (std::size_t i = 0; i < page.code.size(); ++i) {
    const auto& first = page.code[i];
    auto text = page.code[i].text;
    while (text.ends_with('\\') && i + 1 < page.code.size())
      text = text.substr(0, text.size() - 1) + std::string(trim(page.code[++i].text));
    if (const auto line = command_of(first, text); !line.empty())
      out.push_back({fmt::format("{}:{}: ", name, first.number), line});
  }
}

// Lines of blocks are no sentences: they begin and end with ```, and their own ` are the shell's.
void add_of_sentences(const structure::Page& page, const std::string& name, std::vector<ShownCommand>& out) {
  static const std::regex code(R"(`(orbs [^`]*)`)");
  std::size_t next = 0;
  for (std::size_t i = 0; i < page.lines.size(); ++i) {
    while (next < page.code.size() && page.code[next].number < i + 1) ++next;
    if (next < page.code.size() && page.code[next].number == i + 1) continue;
    const auto& text = page.lines[i];
    for (auto at = std::sregex_iterator(text.begin(), text.end(), code); at != std::sregex_iterator(); ++at)
      if (const auto line = (*at)[1].str(); line.find("…") == std::string::npos)
        out.push_back({fmt::format("{}:{}: ", name, i + 1), line, false});
  }
}

}  // namespace

std::vector<ShownCommand> shown_commands() {
  std::vector<ShownCommand> out;
  for (const auto& page : structure::pages_below(kRoot)) {
    const auto name = std::filesystem::relative(page.file, kRoot).string();
    add_of_blocks(page, name, out);
    add_of_sentences(page, name, out);
  }
  return out;
}

std::vector<std::string> shell_words(const std::string& line) {
  std::vector<std::string> words;
  std::string word;
  bool is_word = false;
  char quote = 0;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char letter = line[i];
    if (quote != 0) {
      if (letter == quote)
        quote = 0;
      else
        word += letter;
    } else if (letter == '\'' || letter == '"') {
      quote = letter;
      is_word = true;
    } else if (std::isspace(static_cast<unsigned char>(letter)) != 0) {
      if (is_word) words.push_back(word);
      word.clear();
      is_word = false;
    } else if (std::string_view("|<>;&").find(letter) != std::string_view::npos ||
               (letter == '#' && !is_word)) {
      break;
    } else {
      word += letter == '\\' && i + 1 < line.size() ? line[++i] : letter;
      is_word = true;
    }
  }
  if (is_word) words.push_back(word);
  return words;
}

}  // namespace orbs::cli_tests
