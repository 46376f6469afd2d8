#include "base/error.h"
#include "base/files.h"
#include "base/terminal.h"
#include "cli/program.h"
#include "image/colour.h"
#include "image/image_io.h"
#include "json/writer.h"
#include "judge/difference.h"
#include "judge/noise.h"
#include "metrics/compare.h"
#include "metrics/describe.h"
#include "metrics/image_pair.h"
#include "metrics/table.h"

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

namespace orbs::cli {

namespace {

struct CompareOptions {
  std::string first;
  std::string second;
  std::string metric;
  std::optional<double> min;
  std::optional<double> max;
  std::string maps;
  bool all = false;
  bool definitions = false;
  bool as_json = false;
};

// Images for the screen hold sRGB values; the metrics are defined on linear ones.
image::Image read_linear(const std::string& file) {
  auto image = image::read_image(file);
  if (image::is_ldr_file(file))
    for (auto& value : image.pixels) value = image::srgb_decode(value);
  return image;
}

// Noise and bias would be numbers that mean nothing.
void check_variances(const image::Image& image, const std::string& file) {
  if (const auto problem = judge::variance_problem(image); !problem.empty())
    throw InputError(
        fmt::format("{}: {}, so noise cannot be told from bias; mend these channels, or leave out all of "
                    "variance.R, G and B",
                    file, problem));
}

void print_measurement(const metrics::Measurement& measurement, bool definitions) {
  const auto& metric = *measurement.metric;
  const auto value = !measurement.value               ? "undefined"
                     : std::isinf(*measurement.value) ? "infinite"
                                                      : fmt::format("{:.9g}", *measurement.value);
  auto line = fmt::format("{:<20} {:>14} {}", metric.name, value, metric.unit);
  if (measurement.low && measurement.high)
    line += fmt::format("  {:.4g} to {:.4g}", *measurement.low, *measurement.high);
  if (measurement.where) line += fmt::format("  in {}", rectangle_text(*measurement.where));
  print_clean("{}\n", line);
  if (definitions) print_clean("    {}\n", metric.definition);
}

void print_json(const CompareOptions& options,
                const metrics::Comparison& comparison,
                const std::vector<std::string>& remarks,
                bool is_within) {
  json::Writer out;
  out.begin_object().member("format", "orbs-comparison/1").member("image", options.first);
  out.member("reference", options.second).key("metrics").begin_array();
  for (const auto& measurement : comparison.measurements) {
    const auto& metric = *measurement.metric;
    out.begin_object().member("name", metric.name).key("value");
    // JSON holds no infinite number; the word is that of results.json.
    if (!measurement.value) {
      out.null();
    } else if (std::isinf(*measurement.value)) {
      out.value(*measurement.value > 0 ? "infinite" : "-infinite");
    } else {
      out.value(*measurement.value);
    }
    out.member("unit", metric.unit).member("definition", metric.definition);
    if (measurement.low && measurement.high)
      out.member("low", *measurement.low).member("high", *measurement.high);
    if (measurement.where) out.member("where", rectangle_text(*measurement.where));
    out.end_object();
  }
  out.end_array();
  out.key("remarks").begin_array();
  for (const auto& remark : remarks) out.value(remark);
  out.end_array();
  if (!options.metric.empty()) out.member("within_tolerance", is_within);
  print_raw(stdout, out.end_object().text());
}

// Also true for a number that does not exist: what cannot be measured is not within a tolerance.
bool is_beyond(const CompareOptions& options, const std::optional<double>& value) {
  if (!options.min && !options.max) return false;
  return !value || (options.min && !(*value >= *options.min)) || (options.max && !(*value <= *options.max));
}

int compare_files(CompareOptions options) {
  if (options.metric.empty()) options.metric = options.min || options.max ? "psnr_srgb8" : "";
  if (!options.metric.empty()) metrics::find_metric(options.metric);
  const auto first = read_linear(options.first);
  const auto second = read_linear(options.second);
  check_variances(first, options.first);
  check_variances(second, options.second);
  const auto alignment = metrics::check_alignment(first, second, metrics::NegativePixels::Allowed);
  if (alignment.alignment != metrics::Alignment::Comparable)
    throw InputError(fmt::format("{} (the result) and {} (the reference) cannot be compared: {}",
                                 options.first, options.second, alignment.reason));
  const auto pair = metrics::make_image_pair(first, second, {}, {.threads = 0});
  metrics::MetricSelection selection{.all = options.all};
  if (!options.metric.empty()) selection.also = {options.metric};
  const auto comparison = metrics::compare(pair, selection);
  if (!options.maps.empty()) {
    make_folder(options.maps);
    judge::write_maps(first, comparison, options.maps);
  }
  const auto remarks = metrics::bias_remarks(pair.noise);
  const bool is_within =
      options.metric.empty() || !is_beyond(options, metrics::value_of(comparison, options.metric));
  if (options.as_json) {
    print_json(options, comparison, remarks, is_within);
    return is_within ? 0 : 1;
  }
  for (const auto& measurement : comparison.measurements) print_measurement(measurement, options.definitions);
  for (const auto& remark : remarks) print_clean("{}\n", remark);
  if (is_within) return 0;
  print_clean("beyond the tolerance: {}{}{}\n", options.metric,
              options.min ? fmt::format(", at least {} is needed", *options.min) : "",
              options.max ? fmt::format(", at most {} is allowed", *options.max) : "");
  return 1;
}

}  // namespace

void add_compare_command(const command_line::Command& command, const Program& /*program*/, Action& action) {
  const auto options = std::make_shared<CompareOptions>();
  command.add_option("image", options->first, "The result").required();
  command.add_option("reference", options->second, "The image that it should equal").required();
  command.add_option("--metric", options->metric, "Metric that --min and --max limit (default: psnr_srgb8)");
  command.add_option("--min", options->min, "Smallest value within the tolerance").any_number();
  command.add_option("--max", options->max, "Largest value within the tolerance").any_number();
  command.add_option("--maps", options->maps, "Folder for the error maps, as EXR and PNG")
      .not_empty("a folder");
  command.add_flag("--all", options->all, "Compute the slow metrics too: FLIP, PU21, JERI's SSIM");
  command.add_flag("--definitions", options->definitions, "Print the definition of each number");
  command.add_flag("--json", options->as_json,
                   "Print all numbers with their definitions as JSON, for programs");
  command.footer(
      "Exit status: 0 if the result is within the tolerance, 1 if it is not, 2 if the images cannot be compared.");
  command.callback([=, &action] { action = [=] { return compare_files(*options); }; });
}

}  // namespace orbs::cli
