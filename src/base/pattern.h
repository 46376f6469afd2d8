#pragma once

#include <memory>
#include <string>
#include <vector>

#include <regex.h>

namespace orbs {

/// A POSIX extended regular expression (IEEE Std 1003.1, section 9.4), matched line by line: '^' and '$' are
/// the ends of a line, and no class of characters holds a line break.
class Pattern {
 public:
  /// InputError with the reason when the text is none, refers back to a group, nests more than 50 groups or
  /// has more than 10,000 characters with every bound "{m,n}" written out.
  explicit Pattern(const std::string& text);

  /// How many groups in parentheses it has.
  std::size_t group_count() const { return compiled_->re_nsub; }

  /// What the groups of the last match in `text` hold, "" for one that took no part; empty when nothing
  /// matches.
  std::vector<std::string> last_match(const std::string& text) const;

 private:
  std::shared_ptr<const regex_t> compiled_;
};

}  // namespace orbs
