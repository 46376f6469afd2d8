#include "studies/bench/json.h"

#include "json/writer.h"
#include "results/field_writer.h"
#include "studies/bench/numbers.h"

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
  results::write_record(out, record.host);
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

}  // namespace orbs::studies
