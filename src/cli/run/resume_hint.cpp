#include "cli/run/resume_hint.h"

#include "base/text.h"
#include "cli/program.h"

#include <array>
#include <string_view>

#include <fmt/format.h>

namespace orbs::cli {

namespace {

constexpr std::array<std::string_view, 3> kFolderOptions{"-o", "--output", "--resume"};

// How many words of the command line from the one at `i` on name a folder of the study.
std::size_t folder_words(const std::vector<std::string>& words, std::size_t i) {
  for (const auto option : kFolderOptions) {
    if (words[i] == option) return i + 1 < words.size() ? 2 : 1;
    const bool is_long = option.starts_with("--");
    if (words[i].starts_with(is_long ? fmt::format("{}=", option) : std::string(option))) return 1;
  }
  return 0;
}

}  // namespace

std::vector<std::string> resume_command(const std::vector<std::string>& command_line,
                                        const std::string& folder) {
  std::vector<std::string> words{called_as(command_line)};
  for (std::size_t i = 1; i < command_line.size();) {
    const auto folders = folder_words(command_line, i);
    if (folders == 0) words.push_back(command_line[i]);
    i += folders == 0 ? 1 : folders;
  }
  words.insert(words.end(), {"--resume", folder});
  return words;
}

std::string next_line(const std::vector<std::string>& command_line,
                      const std::string& folder,
                      bool is_finished,
                      const std::string& shows) {
  if (!is_finished)
    return fmt::format("next: {}   (continues this study)\n",
                       shell_text(resume_command(command_line, folder)));
  return fmt::format("next: {}   ({})\n", shell_text({called_as(command_line), "serve", folder}), shows);
}

}  // namespace orbs::cli
