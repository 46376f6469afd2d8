#include "base/error.h"
#include "base/files.h"
#include "base/terminal.h"
#include "cli/compare/compare_folders.h"
#include "cli/compare/compare_images.h"
#include "cli/program.h"
#include "image/layers.h"
#include "json/writer.h"
#include "judge/difference.h"
#include "metrics/compare.h"
#include "metrics/describe.h"
#include "metrics/table.h"

#include <cmath>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace orbs::cli {

namespace {

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

// What the images hold beside their colour: "depth.Z", "S1.R". Ranges of layers only on demand.
void print_channels(metrics::ChannelDifferences channels, bool with_ranges) {
  if (!with_ranges) {
    std::erase_if(channels.both, [](const auto& channel) { return image::is_range(channel.name); });
    std::erase_if(channels.only_result, image::is_range);
    std::erase_if(channels.only_reference, image::is_range);
  }
  if (!channels.both.empty())
    print_clean("{:<20} {:>14} {:>14} {:>14}  {:<14} {}\n", "channel", "mean", "of reference", "largest off",
                "at", "pixels off");
  for (const auto& channel : channels.both)
    print_clean("{:<20} {:>14.7g} {:>14.7g} {:>14.4g}  {:<14} {}\n", channel.name, channel.result_mean,
                channel.reference_mean, channel.largest,
                channel.pixels == 0 ? "" : fmt::format("({}, {})", channel.x, channel.y), channel.pixels);
  if (!channels.only_result.empty())
    print_clean("only in the image: {}\n", fmt::join(channels.only_result, ", "));
  if (!channels.only_reference.empty())
    print_clean("only in the reference: {}\n", fmt::join(channels.only_reference, ", "));
}

void write_channels(json::Writer& out, const metrics::ChannelDifferences& channels) {
  out.key("channels").begin_array();
  for (const auto& channel : channels.both) {
    out.begin_object().member("name", channel.name).member("mean", channel.result_mean);
    out.member("reference_mean", channel.reference_mean).key("largest");
    if (std::isinf(channel.largest))
      out.value("infinite");
    else
      out.value(channel.largest);
    out.member("x", channel.x).member("y", channel.y);
    out.member("pixels", static_cast<double>(channel.pixels)).end_object();
  }
  out.end_array();
}

void print_json(const CompareOptions& options, const ComparedImages& compared, bool is_within) {
  json::Writer out;
  out.begin_object().member("format", "orbs-comparison/1").member("image", options.first);
  out.member("reference", options.second).key("metrics").begin_array();
  for (const auto& measurement : compared.comparison.measurements) {
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
  for (const auto& remark : compared.remarks) out.value(remark);
  out.end_array();
  write_channels(out, compared.channels);
  if (!options.metric.empty()) out.member("within_tolerance", is_within);
  print_raw(stdout, out.end_object().text());
}

int compare_files(const CompareOptions& options) {
  if (!options.page.empty())
    throw InputError("-o writes a page of two folders; --maps writes the error maps of two images");
  const auto compared = compare_images(options.first, options.second, options);
  if (!options.maps.empty()) {
    make_folder(options.maps);
    judge::write_maps(compared.first, compared.comparison, options.maps);
  }
  const bool is_within =
      options.metric.empty() || !is_beyond(options, metrics::value_of(compared.comparison, options.metric));
  if (options.as_json) {
    print_json(options, compared, is_within);
    return is_within ? 0 : 1;
  }
  for (const auto& measurement : compared.comparison.measurements)
    print_measurement(measurement, options.definitions);
  print_channels(compared.channels, options.all);
  for (const auto& remark : compared.remarks) print_clean("{}\n", remark);
  if (!is_within) print_clean("{}\n", tolerance_text(options));
  return is_within ? 0 : 1;
}

int compare_files_or_folders(CompareOptions options) {
  if (options.metric.empty()) options.metric = options.min || options.max ? "psnr_srgb8" : "";
  if (!options.metric.empty()) metrics::find_metric(options.metric);
  const bool has_folder =
      std::filesystem::is_directory(options.first) || std::filesystem::is_directory(options.second);
  return has_folder ? compare_folders(options) : compare_files(options);
}

}  // namespace

void add_compare_command(const command_line::Command& command, const Program& /*program*/, Action& action) {
  const auto options = std::make_shared<CompareOptions>();
  command.add_option("image", options->first, "The result, or a folder of results").required();
  command
      .add_option("reference", options->second,
                  "The image that it should equal, or a folder with images of the same names")
      .required();
  command.add_option("--metric", options->metric, "Metric that --min and --max limit (default: psnr_srgb8)");
  command
      .add_option("--channels", options->channels,
                  "Of images with layers: the layer, as ViewLayer.Combined, or the channel that is compared")
      .value_name("NAME")
      .not_empty("a layer or a channel");
  command.add_option("--min", options->min, "Smallest value within the tolerance").any_number();
  command.add_option("--max", options->max, "Largest value within the tolerance").any_number();
  command.add_option("--maps", options->maps, "Folder for the error maps, as EXR and PNG")
      .not_empty("a folder");
  command
      .add_option("-o,--output", options->page,
                  "Of two folders: also write the images side by side as a page, one HTML file")
      .value_name("FILE")
      .not_empty("a file");
  command.add_flag("--all", options->all, "Compute the slow metrics too: FLIP, PU21, JERI's SSIM");
  command.add_flag("--definitions", options->definitions, "Print the definition of each number");
  command.add_flag("--json", options->as_json,
                   "Print all numbers with their definitions as JSON, for programs");
  command.footer(
      "Two folders: images are paired by their names below the folders, and the worst comes first.\n"
      "Exit status: 0 if the result is within the tolerance, 1 if it is not or an image of two folders is missing or "
      "cannot be compared, 2 if the images cannot be compared or there are none.");
  command.callback([=, &action] { action = [=] { return compare_files_or_folders(*options); }; });
}

}  // namespace orbs::cli
