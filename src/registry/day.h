#pragma once

#include <string>

namespace orbs::registry {

/// A day of the calendar as ISO 8601 writes it, "2026-11-25". Such texts are in the order of their days.
struct Day {
  std::string text{};
};

/// InputError for any other text, and for a day that is in no calendar.
Day parse_day(const std::string& text);

inline const std::string& to_text(const Day& day) { return day.text; }
inline void from_text(const std::string& text, Day& day) { day = parse_day(text); }

/// The day of a local time, "2026-11-25T14:03:00".
inline std::string day_of(const std::string& time) { return time.substr(0, time.find('T')); }

}  // namespace orbs::registry
