#include "studies/bench/report.h"

#include "base/text_table.h"
#include "json/field_writer.h"
#include "json/writer.h"
#include "studies/bench/numbers.h"

#include <functional>

#include <fmt/format.h>

namespace orbs::studies {

namespace {

void put(json::Writer& out, const char* name, const std::optional<SeedNoise>& noise) {
  out.key(name);
  if (!noise) {
    out.null();
    return;
  }
  out.begin_object()
      .member("relative_mse", noise->relative_mse)
      .member("psnr_srgb8_db", noise->psnr_srgb8_db)
      .end_object();
}

void put(json::Writer& out, const char* name, const std::optional<double>& number) {
  out.key(name);
  number ? out.value(*number) : out.null();
}

void put(json::Writer& out, const char* name, const run::RenderCost& render) {
  out.key(name).begin_object();
  out.member("spp", render.spp)
      .member("cpu_seconds", render.cpu_seconds)
      .member("wall_seconds", render.wall_seconds)
      .end_object();
}

void put_renderer(json::Writer& out, const BenchRecord& record, const BenchRenderer& renderer) {
  const auto seconds = equal_cpu_seconds(record);
  out.begin_object().member("name", renderer.name).member("version", renderer.version);
  write_spread(out, "camera_paths_per_cpu_second", paths_per_cpu_second(record, renderer));
  write_spread(out, "camera_paths_per_second", paths_per_second(record, renderer));
  write_spread(out, "start_cpu_seconds", start_cpu_seconds(renderer));
  write_spread(out, "traversal_share", traversal_share(renderer));
  put(out, "noise", renderer.noise);
  put(out, "noise_in_equal_cpu_time", seconds ? noise_at(renderer, *seconds) : std::nullopt);
  if (&renderer != &record.renderers.front())
    write_spread(out, "speed_of_first_over_this", speed_ratio(record.renderers.front(), renderer));
  out.key("rounds").begin_array();
  for (const auto& round : renderer.rounds) {
    out.begin_object();
    put(out, "small", round.small);
    put(out, "large", round.large);
    out.end_object();
  }
  out.end_array().end_object();
}

void put_overhead(json::Writer& out, const BenchRecord& record) {
  out.key("overhead").begin_object();
  write_spread(out, "harness_ms",
               record.overhead ? std::optional(record.overhead->harness_ms) : std::nullopt);
  write_spread(out, "bare_ms", record.overhead ? std::optional(record.overhead->bare_ms) : std::nullopt);
  put(out, "added_ms", overhead_ms(record));
  put(out, "watching_share", watching_share(record));
  out.end_object();
}

void put_start(json::Writer& out, const std::optional<Start>& start) {
  const auto of = [&](Spread Start::*number) {
    return start ? std::optional((*start).*number) : std::nullopt;
  };
  out.key("start").begin_object();
  write_spread(out, "orbs_version_ms", of(&Start::orbs_version_ms));
  write_spread(out, "tracer_version_ms", of(&Start::tracer_version_ms));
  write_spread(out, "pixel_ms", of(&Start::pixel_ms));
  out.end_object();
}

void put_definitions(json::Writer& out) {
  out.key("definitions")
      .begin_object()
      .member("camera_paths_per_cpu_second",
              "pixels times the difference in samples of the large and the small render, over the difference "
              "of their user and system times; start, reading and writing drop out")
      .member("camera_paths_per_second", "the same over the difference of their wall clocks")
      .member("start_cpu_seconds",
              "what is left of the large render's CPU time when its samples are taken off")
      .member("traversal_share",
              "wall clock of all threads inside the accelerator over that of the rendering times its threads")
      .member("relative_mse", kRelativeMseDefinition)
      .member("psnr_srgb8_db", kSeedPsnrDefinition)
      .member("noise_in_equal_cpu_time",
              "noise of the large render, its power scaled as 1 / n to the samples that fit into "
              "equal_cpu_seconds")
      .member("equal_cpu_seconds", "what the first renderer's samples of a large render cost, median")
      .member("overhead.harness_ms",
              "a program that copies an image of this size, as one render: scene written, run by its "
              "supervisor, image read and checked, folder flushed to disk and put into place")
      .member("overhead.bare_ms", "the same program by posix_spawn")
      .member("overhead.added_ms", "difference of the two medians: what each render costs besides itself")
      .member("overhead.watching_share",
              "CPU time of the supervisor over the wall clock of a large render, the most of all")
      .member("start.orbs_version_ms", "user and system time of orbs --version")
      .member("start.tracer_version_ms", "of orbs-tracer --version")
      .member("start.pixel_ms",
              "of orbs-tracer on the scene of the bench at 1 x 1 px, one sample, one thread")
      .member("metrics_cpu_ms", "CPU time of one comparison by all metrics with their maps, median of 5")
      .end_object();
}

}  // namespace

std::string bench_json(const BenchRecord& record) {
  const auto& settings = record.settings;
  json::Writer out;
  out.begin_object()
      .member("format", "orbs-bench/1")
      .member("orbs_version", record.orbs_version)
      .member("started", record.started)
      .member("load", record.load)
      .member("scene", record.scene)
      .member("trace_depth", record.trace_depth)
      .member("size_px", settings.size_px)
      .member("threads", settings.threads)
      .member("spp", settings.spp);
  out.key("host");
  json::write_record(out, record.host);
  out.key("renderers").begin_array();
  for (const auto& renderer : record.renderers) put_renderer(out, record, renderer);
  out.end_array();
  out.key("left_out").begin_array();
  for (const auto& left : record.left_out)
    out.begin_object().member("renderer", left.renderer).member("reason", left.reason).end_object();
  out.end_array();
  out.key("equal_cpu_seconds");
  if (const auto seconds = equal_cpu_seconds(record)) {
    out.value(*seconds);
  } else {
    out.null();
  }
  out.member("metrics_cpu_ms", record.metrics_cpu_ms);
  put_overhead(out, record);
  put_start(out, record.start);
  put_definitions(out);
  return out.end_object().text();
}

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
