#include "report/undecided.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <string_view>

#include <fmt/format.h>

namespace orbs::report {

std::optional<Undecided> undecided_of(const std::string& reason) {
  constexpr std::string_view kUndecided = "undecided: ";
  const auto begin = reason.find(kUndecided);
  // A known failure's reason stands before it.
  if (begin != 0 && (begin == std::string::npos || begin < 2 || reason.compare(begin - 2, 2, "; ") != 0))
    return std::nullopt;
  const auto rest = reason.substr(begin + kUndecided.size());
  Undecided found{rest.substr(0, rest.find_first_of(":;")), {}};
  constexpr std::string_view kAbout = ": about ";
  const auto after = rest.find(kAbout);
  if (after == found.cause.size()) found.times = std::strtod(rest.c_str() + after + kAbout.size(), nullptr);
  return found;
}

std::string undecided_text(const std::vector<Undecided>& targets) {
  auto text = fmt::format("{} undecided: {}", targets.size(), targets.front().cause);
  constexpr std::array kTimes{2.0, 4.0, 16.0, 64.0};
  std::ptrdiff_t told = 0;
  for (const double times : kTimes) {
    const auto decided = std::count_if(targets.begin(), targets.end(), [&](const Undecided& one) {
      return one.times && *one.times <= times;
    });
    if (decided == told) continue;
    text += told == 0 ? fmt::format("; {} times the samples would decide {} of them", times, decided)
                      : fmt::format(", {} times {}", times, decided);
    told = decided;
  }
  if (told > 0) return text;
  double least = HUGE_VAL;
  for (const auto& one : targets) least = std::min(least, one.times.value_or(HUGE_VAL));
  return std::isinf(least)
             ? text
             : fmt::format("{}; {:.0f} times the samples would decide the first of them", text, least);
}

}  // namespace orbs::report
