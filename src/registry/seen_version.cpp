#include "registry/seen_version.h"

#include <cctype>

namespace orbs::registry {

VersionRange range_of_version(const std::string& version) {
  constexpr const char* kDigits = "0123456789";
  const auto begin = version.find_first_of(kDigits);
  if (begin == std::string::npos) return {};
  auto number = version.substr(begin, version.find_first_not_of("0123456789.", begin) - begin);
  number.erase(number.find_last_of(kDigits) + 1);
  const auto is_letter_at = [&](std::size_t at) {
    return at < version.size() && std::isalnum(static_cast<unsigned char>(version[at])) != 0;
  };
  // "v1.2" is usual; "g3" and "3f2a" are names of commits.
  const bool is_name = number.find('.') == std::string::npos &&
                       ((begin > 0 && is_letter_at(begin - 1)) || is_letter_at(begin + number.size()));
  return is_name ? VersionRange{} : parse_version_range("=" + number);
}

}  // namespace orbs::registry
