#include "adapters/process/program_places.h"

#include "adapters/process/programs.h"
#include "base/files_inside.h"
#include "base/text.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <fstream>
#include <optional>
#include <string_view>
#include <system_error>

namespace orbs::adapters {

namespace {

namespace fs = std::filesystem;

// The folders that users and the system keep all sorts of things in: keys, mail, other programs' data.
std::vector<fs::path> private_folders() {
  std::vector<fs::path> folders{"/tmp", "/var/tmp", "/etc"};
  if (const char* home = std::getenv("HOME"); home != nullptr && *home == '/') {
    folders.emplace_back(fs::path(home).lexically_normal());
    folders.emplace_back(folders.back() / ".local");
  }
  std::error_code ignored;
  const auto count = folders.size();
  for (std::size_t i = 0; i < count; ++i) folders.push_back(fs::weakly_canonical(folders[i], ignored));
  return folders;
}

// True for a folder that may be shown whole because a program lies in it.
bool may_be_shown(const fs::path& folder) {
  const auto all = private_folders();
  return folder != "/" &&
         std::none_of(all.begin(), all.end(), [&](const auto& one) { return lies_in(one, folder); });
}

// The words behind #! in the first line of a script; none of another file.
std::vector<std::string> interpreter_words(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  constexpr std::size_t kLongest = 256;  // of which the kernel looks at the first line, BINPRM_BUF_SIZE
  std::array<char, kLongest> head{};
  in.read(head.data(), head.size());
  const auto text = std::string(head.data(), static_cast<std::size_t>(in.gcount()));
  return text.starts_with("#!") ? words_of(text.substr(2, text.find('\n') - 2)) : std::vector<std::string>{};
}

void add(const fs::path& place, std::vector<fs::path>& places) {
  if (std::find(places.begin(), places.end(), place) == places.end()) places.push_back(place);
}

void add_program(const fs::path& program, int depth, std::vector<fs::path>& places) {
  add(program, places);
  std::error_code failed;
  const auto real = fs::canonical(program, failed);
  if (failed) return;
  for (const auto& file : {program, real}) {
    auto folder = file.parent_path();
    if (!may_be_shown(folder)) continue;
    add(folder, places);
    if (folder.filename() != "bin") continue;
    if (const auto prefix = folder.parent_path(); may_be_shown(prefix))
      add(prefix, places);
    else if (const auto libraries = prefix / "lib"; prefix.has_relative_path() && fs::is_directory(libraries))
      add(libraries, places);
  }
  add(real, places);
  constexpr int kDeepest = 4;  // as the kernel follows interpreters of interpreters
  if (depth == kDeepest) return;
  const auto words = interpreter_words(real);
  if (words.empty() || !words.front().starts_with('/')) return;
  add_program(words.front(), depth + 1, places);
  // "#!/usr/bin/env python3": env looks for the program on PATH.
  const bool is_env = fs::path(words.front()).filename() == "env";
  for (std::size_t i = 1; is_env && i < words.size(); ++i)
    if (const auto found = find_program(words[i]); found && !words[i].starts_with('-'))
      return add_program(*found, depth + 1, places);
}

}  // namespace

std::vector<fs::path> program_places(const fs::path& program) {
  std::vector<fs::path> places;
  add_program(fs::absolute(program).lexically_normal(), 0, places);
  return places;
}

std::vector<fs::path> named_places(const std::vector<std::string>& words) {
  std::vector<fs::path> places;
  for (auto word : words) {
    std::replace_if(
        word.begin(), word.end(),
        [](char c) { return std::string_view("=,\"'").find(c) != std::string_view::npos; }, ':');
    for (const auto& part : split(word, ':')) {
      if (!part.starts_with('/')) continue;
      auto place = fs::path(part).lexically_normal();
      if (!place.has_filename()) place = place.parent_path();  // "/opt/lib/"
      std::error_code ignored;
      if (fs::is_regular_file(place, ignored)) add_program(place, 0, places);
      if (fs::is_directory(place, ignored) && may_be_shown(place)) add(place, places);
    }
  }
  return places;
}

}  // namespace orbs::adapters
