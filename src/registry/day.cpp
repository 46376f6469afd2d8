#include "registry/day.h"

#include "base/error.h"
#include "base/text.h"

#include <chrono>
#include <cstddef>

#include <fmt/format.h>

namespace orbs::registry {

namespace {

constexpr std::size_t kYearDigits = 4;
constexpr std::size_t kMonthAt = 5;
constexpr std::size_t kDayAt = 8;

// Whether the text has the form "dddd-dd-dd".
bool has_form(const std::string& text) {
  constexpr std::string_view kForm = "0000-00-00";
  if (text.size() != kForm.size()) return false;
  for (std::size_t i = 0; i < kForm.size(); ++i) {
    const bool is_digit = text[i] >= '0' && text[i] <= '9';
    if (kForm[i] == '0' ? !is_digit : text[i] != kForm[i]) return false;
  }
  return true;
}

}  // namespace

Day parse_day(const std::string& text) {
  if (has_form(text)) {
    const std::string_view all = text;
    const auto number = [&](std::size_t at, std::size_t length) {
      return static_cast<int>(*to_integer(all.substr(at, length)));
    };
    const std::chrono::year_month_day day{std::chrono::year(number(0, kYearDigits)),
                                          std::chrono::month(static_cast<unsigned>(number(kMonthAt, 2))),
                                          std::chrono::day(static_cast<unsigned>(number(kDayAt, 2)))};
    if (day.ok()) return {text};
  }
  throw InputError(
      fmt::format("'{}' is no day; write it as year, month and day, such as '2026-11-25'", text));
}

}  // namespace orbs::registry
