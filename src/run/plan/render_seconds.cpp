#include "run/plan/render_seconds.h"

#include "base/error.h"
#include "base/files_inside.h"
#include "base/pattern.h"
#include "base/text.h"
#include "json/document.h"
#include "json/object_reader.h"

#include <algorithm>
#include <map>

namespace orbs::run {

namespace {

// Seconds in the units of time that programs write.
const std::map<std::string, double>& unit_seconds() {
  static const std::map<std::string, double> kUnits{{"us", 1e-6}, {"ms", 1e-3}, {"s", 1},    {"m", 60},
                                                    {"min", 60},  {"h", 3600},  {"d", 86400}};
  return kUnits;
}

// A number has its unit in the group behind it; without units one number is seconds, two are minutes and
// seconds, three hours, minutes and seconds.
std::optional<double> in_output(const std::string& pattern, const std::string& output) {
  const auto groups = Pattern(pattern).last_match(output);
  if (groups.empty()) return std::nullopt;
  double sum = 0;
  for (std::size_t i = 0; i < groups.size(); ++i) {
    const auto number = to_number(trim(groups[i]));
    if (!number) return std::nullopt;
    const auto unit = i + 1 < groups.size() ? unit_seconds().find(groups[i + 1]) : unit_seconds().end();
    if (unit == unit_seconds().end()) {
      sum = 60 * sum + *number;
    } else {
      sum += *number * unit->second;
      ++i;
    }
  }
  return sum;
}

// The library of regular expressions reads no further than to a NUL.
std::string without_nul(std::string output) {
  std::replace(output.begin(), output.end(), '\0', ' ');
  return output;
}

std::optional<double> in_file(const registry::RenderSeconds& place, const std::filesystem::path& folder) {
  constexpr std::size_t kMost_bytes = std::size_t{16} << 20;
  const auto file = open_inside(folder, place.file);
  if (!file || file->size() > kMost_bytes) return std::nullopt;
  // The renderer's file is its own affair: one that is broken costs its time, not the image.
  try {
    const auto document = json::parse(place.file, file->read(0, static_cast<std::size_t>(file->size())));
    json::ObjectReader at(document);
    const auto keys = split(place.key, '/');
    for (std::size_t i = 0; i + 1 < keys.size(); ++i) at = at.object(keys[i]);
    return at.number(keys.back());
  } catch (const InputError&) {
    return std::nullopt;
  }
}

}  // namespace

std::optional<double> render_seconds(const registry::RenderSeconds& place,
                                     const std::string& output,
                                     const std::filesystem::path& folder) {
  auto number = place.pattern.empty() ? std::nullopt : in_output(place.pattern, without_nul(output));
  if (!place.file.empty()) number = in_file(place, folder);
  if (number) *number *= place.unit_seconds;
  // No render took less than no time, or 30 years: what says so is no time.
  constexpr double kMost_seconds = 1e9;
  return number && *number >= 0 && *number <= kMost_seconds ? number : std::nullopt;
}

void forget_render_seconds(const registry::RenderSeconds& place, const std::filesystem::path& folder) {
  std::error_code ignored;
  if (!place.file.empty() && open_inside(folder, place.file))
    std::filesystem::remove(folder / place.file, ignored);
}

}  // namespace orbs::run
