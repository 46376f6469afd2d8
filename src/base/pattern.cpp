#include "base/pattern.h"

#include "base/error.h"

#include <array>

#include <fmt/format.h>

namespace orbs {

namespace {

std::shared_ptr<const regex_t> compiled(const std::string& text) {
  auto made = std::make_unique<regex_t>();
  if (const int failed = ::regcomp(made.get(), text.c_str(), REG_EXTENDED | REG_NEWLINE); failed != 0) {
    std::array<char, 200> reason{};
    ::regerror(failed, made.get(), reason.data(), reason.size());
    throw InputError(fmt::format("'{}' is no regular expression: {}", text, reason.data()));
  }
  return std::shared_ptr<regex_t>(made.release(), [](regex_t* owned) {
    ::regfree(owned);
    delete owned;
  });
}

}  // namespace

Pattern::Pattern(const std::string& text) : compiled_(compiled(text)) {}

std::vector<std::string> Pattern::last_match(const std::string& text) const {
  std::vector<regmatch_t> found(group_count() + 1);
  std::vector<std::string> groups;
  const char* at = text.c_str();
  int flags = 0;
  while (::regexec(compiled_.get(), at, found.size(), found.data(), flags) == 0) {
    groups.clear();
    for (std::size_t i = 1; i < found.size(); ++i)
      groups.push_back(found[i].rm_so < 0 ? "" : std::string(at + found[i].rm_so, at + found[i].rm_eo));
    // An empty match would be found again where it ends.
    const auto next = found[0].rm_eo > 0 ? found[0].rm_eo : 1;
    if (at + next > text.c_str() + text.size()) break;
    // What is behind a match is the start of a line only where a line ends before it.
    flags = at[next - 1] == '\n' ? 0 : REG_NOTBOL;
    at += next;
  }
  return groups;
}

}  // namespace orbs
