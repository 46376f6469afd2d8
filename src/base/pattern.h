#pragma once

#include <memory>
#include <string>
#include <vector>

#include <regex.h>

namespace orbs {

/// A POSIX extended regular expression (IEEE Std 1003.1, section 9.4), matched line by line: '^' and '$' are
/// the ends of a line, and no class of characters holds a line break. A carriage return ends a line, too,
/// as programs rewrite their line of progress by it.
class Pattern {
 public:
  /// InputError with the reason if the text is no expression, refers back to a group, nests more than 50
  /// groups or, with every bound "{m,n}" written out, has more than 10,000 characters.
  explicit Pattern(const std::string& text);

  /// The number of groups in parentheses.
  std::size_t group_count() const { return compiled_->re_nsub; }

  /// The texts of the groups in the last match in `text`, "" for a group that took no part. Empty if nothing
  /// matches. Lines of more than 1000 bytes are not searched.
  std::vector<std::string> last_match(const std::string& text) const;

  /// Whether something in the line matches; not for a line of more than 1000 bytes.
  bool matches(const std::string& line) const;

 private:
  std::vector<std::string> last_match_in_line(const std::string& line) const;

  std::shared_ptr<const regex_t> compiled_;
};

}  // namespace orbs
