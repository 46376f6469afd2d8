#include "studies/bench/report.h"

#include "base/text_table.h"
#include "studies/bench/numbers.h"

#include <functional>

#include <fmt/format.h>

namespace orbs::studies {

namespace {

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

TableRow row(const BenchRecord& record,
             const std::string& label,
             const std::function<std::string(const BenchRenderer&)>& cell) {
  TableRow cells{label};
  for (const auto& renderer : record.renderers) cells.push_back(cell(renderer));
  return cells;
}

void add_speed(const BenchRecord& record, std::vector<TableRow>& rows) {
  constexpr double kMillion = 1e6;
  rows.push_back(row(record, "million camera paths per CPU second", [&](const auto& r) {
    return spread_text(paths_per_cpu_second(record, r), kMillion, 3);
  }));
  rows.push_back(row(record, "million camera paths per second, all threads",
                     [&](const auto& r) { return spread_text(paths_per_second(record, r), kMillion, 3); }));
  rows.push_back(row(record, "CPU s besides the samples (start, files)",
                     [&](const auto& r) { return spread_text(start_cpu_seconds(r), 1, 2); }));
  rows.push_back(row(record, "time inside ray traversal, %",
                     [&](const auto& r) { return spread_text(traversal_share(r), 0.01, 1); }));
}

void add_noise(const BenchRecord& record, std::vector<TableRow>& rows) {
  rows.push_back(row(record, fmt::format("noise of {} spp: relative MSE", record.settings.spp),
                     [](const auto& r) { return noise_text(r.noise, &SeedNoise::relative_mse, 4); }));
  rows.push_back(row(record, "    psnr_srgb8, dB",
                     [](const auto& r) { return noise_text(r.noise, &SeedNoise::psnr_srgb8_db, 4); }));
  const auto seconds = equal_cpu_seconds(record);
  if (!seconds) return;
  rows.push_back(
      row(record, fmt::format("noise of {:.2f} s of CPU: relative MSE", *seconds),
          [&](const auto& r) { return noise_text(noise_at(r, *seconds), &SeedNoise::relative_mse, 4); }));
  rows.push_back(row(record, "    psnr_srgb8, dB", [&](const auto& r) {
    return noise_text(noise_at(r, *seconds), &SeedNoise::psnr_srgb8_db, 4);
  }));
}

void add_ratios(const BenchRecord& record, std::vector<TableRow>& rows) {
  const auto& first = record.renderers.front();
  for (std::size_t i = 1; i < record.renderers.size(); ++i) {
    const auto& other = record.renderers[i];
    rows.push_back({fmt::format("{} over {}: camera paths per CPU second", first.name, other.name),
                    spread_text(speed_ratio(first, other), 1, 2)});
    const auto seconds = equal_cpu_seconds(record);
    const auto of_first = seconds ? noise_at(first, *seconds) : std::nullopt;
    const auto of_other = seconds ? noise_at(other, *seconds) : std::nullopt;
    if (of_first && of_other)
      rows.push_back({fmt::format("{} over {}: relative MSE in equal CPU time", first.name, other.name),
                      fmt::format("{:.3f}", of_first->relative_mse / of_other->relative_mse)});
  }
}

void add_overhead(const BenchRecord& record, std::vector<TableRow>& rows) {
  rows.push_back({fmt::format("all metrics with maps, {0} x {0} px: CPU ms", record.settings.size_px),
                  fmt::format("{:.1f}", record.metrics_cpu_ms)});
  if (record.start) {
    const auto& start = *record.start;
    rows.push_back({"start: orbs --version, CPU ms", spread_text(start.orbs_version_ms, 1, 1)});
    rows.push_back({"    orbs-tracer --version, CPU ms", spread_text(start.tracer_version_ms, 1, 1)});
    rows.push_back({"    orbs-tracer, 1 x 1 px: CPU ms", spread_text(start.pixel_ms, 1, 1)});
  }
  const auto added_ms = overhead_ms(record);
  const auto watching = watching_share(record);
  if (!added_ms || !watching) return;
  rows.push_back({"the harness adds to each render: ms", fmt::format("{:.1f}", *added_ms)});
  rows.push_back({"    of one core while it renders, at most: %", fmt::format("{:.2f}", 100 * *watching)});
}

}  // namespace

std::string bench_table(const BenchRecord& record) {
  const auto& settings = record.settings;
  auto text =
      fmt::format("{}, {} x {} px, trace depth {}, {} spp, {} threads, {} rounds\n{}, load {:.1f}\n\n",
                  record.scene, settings.size_px, settings.size_px, record.trace_depth, settings.spp,
                  settings.threads, settings.rounds, results::timing_machine(record.host), record.load);
  std::vector<TableRow> rows{row(record, "median (least to most)", [](const auto& r) { return r.name; })};
  add_speed(record, rows);
  add_noise(record, rows);
  rows.emplace_back();
  add_ratios(record, rows);
  add_overhead(record, rows);
  std::vector<Align> columns(1 + record.renderers.size(), Align::Right);
  columns.front() = Align::Left;
  text += text_table(rows, columns);
  for (const auto& left : record.left_out)
    text += fmt::format("\n{} is not in the table: {}\n", left.renderer, left.reason);
  return text;
}

}  // namespace orbs::studies
