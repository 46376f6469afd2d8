#include "studies/cost/svg.h"

#include "studies/cost/numbers.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

namespace orbs::studies {

namespace {

// Pixels.
constexpr int kColumns = 4;
constexpr double kWidth = 220;  // of a chart with its margins
constexpr double kHeight = 170;
constexpr double kLeft = 40, kRight = 14, kTop = 22, kBottom = 24;
constexpr double kLegend = 28;

// The palette of Okabe and Ito, distinguishable with any colour vision deficiency, darkened for white.
constexpr std::array kColours{"#0072b2", "#b85600", "#007f5c", "#a3437f", "#7d6a00", "#5a5a5a"};

const char* colour_of(std::size_t renderer) { return kColours.at(renderer % kColours.size()); }

// Whole decades around all values.
struct LogAxis {
  double low = INFINITY;  // decimal exponents
  double high = -INFINITY;

  void add(double value) {
    if (!(value > 0)) return;
    low = std::min(low, std::floor(std::log10(value)));
    high = std::max(high, std::ceil(std::log10(value)));
  }
  double at(double value) const { return (std::log10(value) - low) / std::max(high - low, 1.0); }
};

struct Axes {
  LogAxis seconds, error;

  double x(double value) const { return kLeft + seconds.at(value) * (kWidth - kLeft - kRight); }
  double y(double value) const { return kHeight - kBottom - error.at(value) * (kHeight - kTop - kBottom); }
};

// An error of zero or below, which the noise of the reference has swallowed, has no place on the axis.
bool can_be_drawn(const CostPoint& point) {
  return point.errors[kRelmse] && point.errors[kRelmse]->value > 0 && point.cpu_seconds.value > 0;
}

Axes axes_of(const CostNumbers& numbers) {
  Axes axes;
  for (const auto& curve : numbers.curves)
    for (const auto& point : curve.points)
      if (can_be_drawn(point)) {
        axes.seconds.add(point.cpu_seconds.value);
        axes.error.add(point.errors[kRelmse]->value);
      }
  return axes;
}

// In XML.
std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '&')
      out += "&amp;";
    else if (c == '<')
      out += "&lt;";
    else
      out += c;
  }
  return out;
}

std::string power_of_ten(int exponent) {
  if (exponent >= -1 && exponent <= 3) return fmt::format("{:g}", std::pow(10.0, exponent));
  return fmt::format("1e{}", exponent);
}

std::string grid(const Axes& axes) {
  std::string out;
  for (int e = static_cast<int>(axes.seconds.low); e <= static_cast<int>(axes.seconds.high); ++e) {
    const double x = axes.x(std::pow(10.0, e));
    out += fmt::format(
        "<path class=\"g\" d=\"M{:.1f} {}V{}\"/><text x=\"{:.1f}\" y=\"{}\" "
        "text-anchor=\"middle\">{}</text>\n",
        x, kTop, kHeight - kBottom, x, kHeight - kBottom + 13, power_of_ten(e));
  }
  for (int e = static_cast<int>(axes.error.low); e <= static_cast<int>(axes.error.high); ++e) {
    const double y = axes.y(std::pow(10.0, e));
    out += fmt::format(
        "<path class=\"g\" d=\"M{} {:.1f}H{}\"/><text x=\"{}\" y=\"{:.1f}\" "
        "text-anchor=\"end\">{}</text>\n",
        kLeft, y, kWidth - kRight, kLeft - 4, y + 3.5, power_of_ten(e));
  }
  return out;
}

std::string point_mark(const Axes& axes, const CostPoint& point, const char* colour) {
  const double x = axes.x(point.cpu_seconds.value);
  const auto& error = *point.errors[kRelmse];
  const double lowest = std::pow(10.0, axes.error.low);
  const double highest = std::pow(10.0, axes.error.high);
  return fmt::format(
      "<path d=\"M{0:.1f} {1:.1f}V{2:.1f}\" stroke=\"{3}\"/><circle cx=\"{0:.1f}\" cy=\"{4:.1f}\" r=\"2.5\" "
      "stroke=\"{3}\" fill=\"{5}\"/>\n",
      x, axes.y(std::clamp(error.low, lowest, highest)), axes.y(std::clamp(error.high, lowest, highest)),
      colour, axes.y(error.value), point.is_below_reference_noise ? "#fff" : colour);
}

std::string curve_marks(const Axes& axes, const CostCurve& curve, const char* colour) {
  std::string line, marks;
  for (const auto& point : curve.points) {
    if (!can_be_drawn(point)) continue;
    line += fmt::format("{}{:.1f} {:.1f}", line.empty() ? "M" : "L", axes.x(point.cpu_seconds.value),
                        axes.y(point.errors[kRelmse]->value));
    marks += point_mark(axes, point, colour);
  }
  if (curve.fit && curve.fit->has_floor && curve.fit->bias_squared.value > 0) {
    const double y = axes.y(curve.fit->bias_squared.value);
    marks += fmt::format("<path d=\"M{} {:.1f}H{}\" stroke=\"{}\" stroke-dasharray=\"4 3\"/>\n", kLeft, y,
                         kWidth - kRight, colour);
  }
  return fmt::format("<path d=\"{}\" stroke=\"{}\" fill=\"none\"/>\n{}", line, colour, marks);
}

std::string chart(const CostRecord& record,
                  const CostNumbers& numbers,
                  const Axes& axes,
                  std::size_t target) {
  const auto& about = record.targets[target];
  std::string out = fmt::format("<text x=\"{}\" y=\"14\" class=\"t\">{} {}</text>\n{}", kLeft,
                                escaped(about.requirement), escaped(about.name), grid(axes));
  for (const auto& curve : numbers.curves)
    if (const auto& ladder = record.ladders[curve.ladder]; ladder.target == target)
      out += curve_marks(axes, curve, colour_of(ladder.renderer));
  return out;
}

std::string legend(const CostRecord& record) {
  std::string out;
  double x = kLeft;
  for (std::size_t i = 0; i < record.renderers.size(); ++i) {
    out += fmt::format(
        "<circle cx=\"{0}\" cy=\"14\" r=\"4\" fill=\"{1}\"/><text x=\"{2}\" y=\"18\" "
        "class=\"t\">{3}</text>\n",
        x, colour_of(i), x + 9, escaped(record.renderers[i].name));
    x += 30 + 7.5 * static_cast<double>(record.renderers[i].name.size());
  }
  return out +
         fmt::format("<text x=\"{}\" y=\"18\">relMSE against CPU seconds, size {}</text>\n", x, record.size);
}

}  // namespace

std::string cost_svg(const CostRecord& record) {
  const auto numbers = cost_numbers(record);
  const auto axes = axes_of(numbers);
  const auto rows = (record.targets.size() + kColumns - 1) / kColumns;
  std::string out = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" height=\"{1}\" "
      "font-family=\"sans-serif\" font-size=\"10\" fill=\"#444\">\n"
      "<style>.g{{stroke:#ddd}}.t{{font-size:12px;fill:#111}}</style>\n"
      "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n{2}",
      kColumns * kWidth, kLegend + static_cast<double>(rows) * kHeight, legend(record));
  for (std::size_t i = 0; i < record.targets.size(); ++i) {
    const std::size_t row = i / kColumns;
    const std::size_t column = i % kColumns;
    out += fmt::format("<g transform=\"translate({} {})\">\n{}</g>\n", kWidth * static_cast<double>(column),
                       kLegend + kHeight * static_cast<double>(row), chart(record, numbers, axes, i));
  }
  return out + "</svg>\n";
}

}  // namespace orbs::studies
