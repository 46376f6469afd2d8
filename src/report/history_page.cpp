#include "report/history_page.h"

#include "history/history_text.h"
#include "report/files.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace orbs::report {

namespace {

using history::History;
using history::Point;
using history::Series;

constexpr double kWidth_px = 220;
constexpr double kHeight_px = 36;
constexpr double kMargin_px = 4;

constexpr const char* kHead = R"(<!doctype html>
<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width">
<title>History of runs</title>
<style>
:root { color-scheme: light dark; font: 14px/1.4 system-ui, sans-serif; }
body { margin: 1.5rem; }
.wide { overflow-x: auto; }
table { border-collapse: collapse; margin: 1rem 0; }
th, td { text-align: left; padding: .15rem .6rem; border-bottom: 1px solid #8884; white-space: nowrap; }
svg { vertical-align: middle; }
polyline { fill: none; stroke: currentColor; stroke-width: 1; opacity: .5; }
circle { fill: currentColor; }
.fail { fill: #d33; color: #d33; }
.known { fill: #888; }
</style></head><body>
)";

std::string class_of(const Point& point) {
  if (point.expectation == results::Expectation::Known) return " class=\"known\"";
  return counts_as_failure(point.verdict, point.expectation) ? " class=\"fail\"" : "";
}

std::string title_of(const Point& point, const History& history, double value, const char* unit) {
  const auto& run = history.runs[point.run];
  return xml_text(fmt::format("{:.4g} {}, {}\n{}, {}\n{}; orbs {}", value, unit,
                              state_name(point.verdict, point.expectation), run.name, run.started,
                              point.version, run.orbs_version));
}

// A line through the points that have a number, over all runs from left to right; the vertical axis reaches
// from the least to the greatest number.
std::string chart(const Series& series,
                  const History& history,
                  const std::function<std::optional<double>(const Point&)>& number,
                  const char* unit) {
  std::vector<std::pair<const Point*, double>> shown;
  for (const auto& point : series.points)
    if (const auto value = number(point); value && std::isfinite(*value)) shown.emplace_back(&point, *value);
  if (shown.empty()) return "";
  const auto [least, greatest] = std::minmax_element(
      shown.begin(), shown.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
  const double range = greatest->second - least->second;
  const auto last = static_cast<double>(std::max<std::size_t>(history.runs.size(), 2) - 1);
  std::string line;
  std::string dots;
  for (const auto& [point, value] : shown) {
    const double x = kMargin_px + (kWidth_px - 2 * kMargin_px) * static_cast<double>(point->run) / last;
    const double share = range > 0 ? (value - least->second) / range : 0.5;
    const double y = kHeight_px - kMargin_px - (kHeight_px - 2 * kMargin_px) * share;
    line += fmt::format("{:.1f},{:.1f} ", x, y);
    dots += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"2.5\"{}><title>{}</title></circle>", x, y,
                        class_of(*point), title_of(*point, history, value, unit));
  }
  return fmt::format(
      "<svg width=\"{}\" height=\"{}\" role=\"img\" aria-label=\"{:.4g} to {:.4g} {}\"><polyline points=\"{}\"/>{}</svg>",
      kWidth_px, kHeight_px, least->second, greatest->second, unit, line, dots);
}

std::string number_cell(const std::optional<double>& value) {
  if (!value) return "";
  return std::isinf(*value) ? "inf" : fmt::format("{:.2f}", *value);
}

std::string target_row(const Series& series, const History& history) {
  const auto summary = history::summary_of(series);
  return fmt::format(
      "<tr><td>{}</td><td>{}</td><td>{}</td><td{}>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td>"
      "<td>{}{}</td></tr>\n",
      xml_text(series.requirement), xml_text(series.renderer), xml_text(series.target),
      class_of(series.points.back()), xml_text(summary.now), number_cell(summary.newest_db),
      chart(
          series, history, [](const Point& point) { return point.psnr_db; }, "dB"),
      number_cell(summary.newest_seconds),
      chart(
          series, history, [](const Point& point) { return point.cpu_seconds; }, "s"),
      xml_text(summary.states), summary.is_flaky ? "; <b>flaky</b>" : "");
}

std::string step_row(const history::Change& step) {
  return fmt::format(
      "<tr><td{}>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td></tr>\n",
      step.direction == history::Direction::Worse ? " class=\"fail\"" : "", direction_name(step.direction),
      xml_text(step.renderer), step.target.empty() ? "all together" : xml_text(step.target),
      quantity_name(step.quantity), xml_text(step.before), xml_text(step.after), xml_text(step.since));
}

}  // namespace

std::string history_page(const History& history, const std::vector<history::Change>& steps) {
  auto text = fmt::format("{}<h1>{}</h1>\n", kHead, xml_text(history::headline(history)));
  if (!steps.empty()) {
    text +=
        "<h2>Steps</h2>\n<div class=\"wide\" tabindex=\"0\" role=\"region\" aria-label=\"Steps\"><table><tr><th></th><th>renderer</th><th>target</th><th></th><th>before</th>"
        "<th>after</th><th>since</th></tr>\n";
    for (const auto& step : steps) text += step_row(step);
    text += "</table></div>\n";
  }
  if (const auto flaky = history::flaky_targets(history); !flaky.empty())
    text += fmt::format("<p>Flaky (the verdict differs between seeds): {}</p>\n",
                        xml_text(fmt::format("{}", fmt::join(flaky, ", "))));
  text +=
      "<h2>Targets</h2>\n<div class=\"wide\" tabindex=\"0\" role=\"region\" aria-label=\"Targets\"><table><tr><th></th><th>renderer</th><th>target</th><th>now</th><th>PSNR / dB</th>"
      "<th>over the runs</th><th>CPU / s</th><th>over the runs</th><th>runs with each verdict</th></tr>\n";
  for (const auto& series : history.series) text += target_row(series, history);
  text += "</table></div>\n";
  for (const auto& note : history.notes) text += fmt::format("<p>{}</p>\n", xml_text(note));
  return text + "</body></html>\n";
}

}  // namespace orbs::report
