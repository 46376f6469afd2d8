#include "supervisor/report.h"

#include "base/text.h"

#include <map>

#include <fmt/format.h>

namespace orbs::supervisor {

namespace {

constexpr std::string_view kLastLine = "end";
constexpr int kMostCause = static_cast<int>(Cause::Stopped);

std::map<std::string, std::string> lines_of(std::string_view text) {
  std::map<std::string, std::string> values;
  for (const auto& line : split(text, '\n')) {
    const auto space = line.find(' ');
    values[line.substr(0, space)] = space == std::string::npos ? "" : line.substr(space + 1);
  }
  return values;
}

}  // namespace

std::string report_text(const Report& report) {
  return fmt::format(
      "start_error {}\n"
      "cause {}\n"
      "exit_code {}\n"
      "signal {}\n"
      "core_dumped {}\n"
      "wall_seconds {}\n"
      "user_seconds {}\n"
      "system_seconds {}\n"
      "peak_rss_bytes {}\n"
      "left_behind {}\n"
      "supervisor_cpu_seconds {}\n"
      "{}\n",
      report.start_error, static_cast<int>(report.cause), report.exit_code, report.signal,
      static_cast<int>(report.core_dumped), report.wall_seconds, report.user_seconds, report.system_seconds,
      report.peak_rss_bytes, report.left_behind, report.supervisor_cpu_seconds, kLastLine);
}

std::optional<Report> parse_report(std::string_view text) {
  const auto values = lines_of(text);
  if (!values.contains(std::string(kLastLine))) return std::nullopt;
  bool whole = true;
  const auto number = [&](const std::string& key) {
    const auto found = values.find(key);
    const auto value = found == values.end() ? std::nullopt : to_number(found->second);
    whole = whole && value;
    return value.value_or(0);
  };
  const auto integer = [&](const std::string& key) { return static_cast<int>(number(key)); };
  Report report;
  if (const auto found = values.find("start_error"); found != values.end())
    report.start_error = found->second;
  const int cause = integer("cause");
  if (cause < 0 || cause > kMostCause) return std::nullopt;
  report.cause = static_cast<Cause>(cause);
  report.exit_code = integer("exit_code");
  report.signal = integer("signal");
  report.core_dumped = integer("core_dumped") != 0;
  report.wall_seconds = number("wall_seconds");
  report.user_seconds = number("user_seconds");
  report.system_seconds = number("system_seconds");
  report.peak_rss_bytes = static_cast<std::size_t>(number("peak_rss_bytes"));
  report.left_behind = integer("left_behind");
  report.supervisor_cpu_seconds = number("supervisor_cpu_seconds");
  return whole ? std::optional(report) : std::nullopt;
}

}  // namespace orbs::supervisor
