#include "studies/bench_report.h"

#include "studies/bench_numbers.h"

#include <functional>

#include <fmt/format.h>

namespace orbs::studies {

namespace {

constexpr int kLabel = 44;
constexpr int kColumn = 26;

std::string spread_text(const std::optional<Spread>& spread, double unit, int decimals) {
  if (!spread) return "-";
  const auto text = fmt::format("{:.{}f}", spread->median / unit, decimals);
  if (spread->least == spread->most) return text;
  return fmt::format("{} ({:.{}f} to {:.{}f})", text, spread->least / unit, decimals, spread->most / unit,
                     decimals);
}

std::string noise_text(const std::optional<SeedNoise>& noise, double SeedNoise::*number, int significant) {
  return noise ? fmt::format("{:.{}g}", (*noise).*number, significant) : "-";
}

std::string line(const BenchRecord& record,
                 const std::string& label,
                 const std::function<std::string(const BenchRenderer&)>& cell) {
  auto text = fmt::format("{:<{}}", label, kLabel);
  for (const auto& renderer : record.renderers) text += fmt::format("{:>{}}", cell(renderer), kColumn);
  return text + "\n";
}

std::string speed_lines(const BenchRecord& record) {
  constexpr double kMillion = 1e6;
  return line(record, "million camera paths per CPU second",
              [&](const auto& r) { return spread_text(paths_per_cpu_second(record, r), kMillion, 3); }) +
         line(record, "million camera paths per second, all threads",
              [&](const auto& r) { return spread_text(paths_per_second(record, r), kMillion, 3); }) +
         line(record, "CPU s besides the samples (start, files)",
              [&](const auto& r) { return spread_text(start_cpu_seconds(r), 1, 2); }) +
         line(record, "of its time inside ray traversal, %",
              [&](const auto& r) { return spread_text(traversal_share(r), 0.01, 1); });
}

std::string noise_lines(const BenchRecord& record) {
  auto text = line(record, fmt::format("noise of {} spp: relative MSE", record.settings.spp),
                   [](const auto& r) { return noise_text(r.noise, &SeedNoise::relative_mse, 4); }) +
              line(record, "    psnr_srgb8, dB",
                   [](const auto& r) { return noise_text(r.noise, &SeedNoise::psnr_srgb8_db, 4); });
  const auto seconds = equal_cpu_seconds(record);
  if (!seconds) return text;
  return text +
         line(record, fmt::format("noise of {:.2f} s of CPU: relative MSE", *seconds),
              [&](const auto& r) { return noise_text(noise_at(r, *seconds), &SeedNoise::relative_mse, 4); }) +
         line(record, "    psnr_srgb8, dB",
              [&](const auto& r) { return noise_text(noise_at(r, *seconds), &SeedNoise::psnr_srgb8_db, 4); });
}

std::string ratio_lines(const BenchRecord& record) {
  std::string text;
  const auto& first = record.renderers.front();
  for (std::size_t i = 1; i < record.renderers.size(); ++i) {
    const auto& other = record.renderers[i];
    text += fmt::format("{:<{}}{:>{}}\n",
                        fmt::format("{} over {}: camera paths per CPU second", first.name, other.name),
                        kLabel + 4, spread_text(speed_ratio(first, other), 1, 2), kColumn - 4);
    const auto seconds = equal_cpu_seconds(record);
    const auto of_first = seconds ? noise_at(first, *seconds) : std::nullopt;
    const auto of_other = seconds ? noise_at(other, *seconds) : std::nullopt;
    if (of_first && of_other)
      text += fmt::format("{:<{}}{:>{}.3f}\n",
                          fmt::format("{} over {}: relative MSE in equal CPU time", first.name, other.name),
                          kLabel + 4, of_first->relative_mse / of_other->relative_mse, kColumn - 4);
  }
  return text;
}

std::string overhead_lines(const BenchRecord& record) {
  const auto added_ms = overhead_ms(record);
  const auto watching = watching_share(record);
  if (!added_ms || !watching) return "";
  const auto number = [](const std::string& label, const std::string& value) {
    return fmt::format("{:<{}}{:>{}}\n", label, kLabel + 4, value, kColumn - 4);
  };
  return number("the harness adds to each render: ms", fmt::format("{:.1f}", *added_ms)) +
         number("    of one core while it renders, at most: %", fmt::format("{:.2f}", 100 * *watching));
}

}  // namespace

std::string bench_table(const BenchRecord& record) {
  const auto& settings = record.settings;
  auto text =
      fmt::format("{}, {} x {} px, trace depth {}, {} spp, {} threads, {} rounds\n{}, load {:.1f}\n\n",
                  record.scene, settings.size_px, settings.size_px, record.trace_depth, settings.spp,
                  settings.threads, settings.rounds, results::timing_machine(record.host), record.load);
  text += line(record, "median (least to most)", [](const auto& r) { return r.name; });
  text += speed_lines(record) + noise_lines(record) + "\n" + ratio_lines(record);
  text += fmt::format("{:<{}}{:>{}.1f}\n",
                      fmt::format("all metrics with maps, {0} x {0} px: CPU ms", settings.size_px),
                      kLabel + 4, record.metrics_cpu_ms, kColumn - 4);
  text += overhead_lines(record);
  for (const auto& left : record.left_out)
    text += fmt::format("\n{} is not in the table: {}\n", left.renderer, left.reason);
  return text;
}

}  // namespace orbs::studies
