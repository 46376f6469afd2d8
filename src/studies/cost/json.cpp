#include "studies/cost/json.h"

#include "base/error.h"
#include "json/document.h"
#include "json/writer.h"
#include "results/cost_study.h"
#include "results/field_reader.h"
#include "results/field_writer.h"
#include "studies/cost/numbers.h"

#include <fmt/format.h>

namespace orbs::studies {

namespace {

using json::Writer;

void put(Writer& out, std::string_view name, const std::optional<Interval>& interval) {
  out.key(name);
  if (!interval) {
    out.null();
    return;
  }
  out.begin_object()
      .member("value", interval->value)
      .member("low", interval->low)
      .member("high", interval->high)
      .end_object();
}

void put_point(Writer& out, const CostRecord& record, const CostLadder& ladder, const CostPoint& point) {
  const auto& rung = ladder.rungs[point.rung];
  out.begin_object().member("rung", rung.name).member("spp", rung.spp).member("renders", point.renders);
  put(out, "cpu_seconds", point.cpu_seconds);
  put(out, "wall_seconds", point.wall_seconds);
  put(out, "render_seconds", point.render_seconds);
  out.key("errors").begin_object();
  for (std::size_t metric = 0; metric < kCostMetrics.size(); ++metric)
    put(out, kCostMetrics.at(metric).name, point.errors.at(metric));
  out.end_object()
      .member("below_reference_noise", point.is_below_reference_noise)
      .member("on_frontier", point.is_on_frontier)
      .member("image", image_file(record, ladder, point.rung, "png"))
      .member("exr", image_file(record, ladder, point.rung, "exr"))
      .end_object();
}

void put_fit(Writer& out, const std::optional<ErrorFit>& fit, const std::string& finding) {
  out.key("fit");
  if (!fit) {
    out.null();
    return;
  }
  out.begin_object();
  put(out, "bias_squared", fit->bias_squared);
  put(out, "variance", fit->variance);
  put(out, "exponent", fit->exponent);
  out.member("misfit", fit->misfit)
      .member("has_floor", fit->has_floor)
      .member("floor_named", fit->has_floor ? finding : "")
      .end_object();
}

void put_price(Writer& out, const CostPrice& price) {
  out.begin_object()
      .member("metric", kCostMetrics.at(price.goal.metric).name)
      .member("level", price.goal.level);
  put(out, "cpu_seconds", price.cpu_seconds);
  out.member("note", price.note).end_object();
}

void put_curve(Writer& out, const CostRecord& record, const CostCurve& curve) {
  const auto& ladder = record.ladders[curve.ladder];
  out.begin_object()
      .member("target", static_cast<int>(ladder.target))
      .member("renderer", static_cast<int>(ladder.renderer));
  // What was not measured is no cost of zero.
  const bool is_measured = curve.fixed_cpu_seconds.value > 0;
  put(out, "fixed_cpu_seconds", is_measured ? std::optional(curve.fixed_cpu_seconds) : std::nullopt);
  out.key("points").begin_array();
  for (const auto& point : curve.points) put_point(out, record, ladder, point);
  out.end_array();
  put_fit(out, curve.fit, ladder.finding);
  out.key("prices").begin_array();
  for (const auto& price : curve.prices) put_price(out, price);
  out.end_array();
  put(out, "efficiency", curve.efficiency);
  put(out, "seconds_per_db", curve.seconds_per_db);
  out.member("note", ladder.note).end_object();
}

void put_comparison(Writer& out, const CostComparison& comparison) {
  out.begin_object()
      .member("target", static_cast<int>(comparison.target))
      .member("metric", kCostMetrics.at(comparison.goal.metric).name)
      .member("level", comparison.goal.level)
      .member("first", static_cast<int>(comparison.first))
      .member("second", static_cast<int>(comparison.second));
  put(out, "time_ratio", comparison.time_ratio);
  out.member("verdict", comparison.verdict).member("note", comparison.note).end_object();
}

void put_self_comparison(Writer& out, const CostRecord& record, const std::optional<SelfComparison>& found) {
  out.key("self_comparison");
  if (!found) {
    out.null();
    return;
  }
  const auto& ladder = record.ladders[found->ladder];
  out.begin_object()
      .member("renderer", static_cast<int>(ladder.renderer))
      .member("target", static_cast<int>(ladder.target))
      .member("pairs", found->pairs);
  put(out, "time_ratio", found->time_ratio);
  put(out, "error_ratio", found->error_ratio);
  out.member("passed", found->passed)
      .member("note", found->is_known ? "the same renderer twice under two names"
                                      : "too uncertain to show anything: more seeds are needed")
      .end_object();
}

void put_metrics(Writer& out) {
  out.key("metrics").begin_array();
  for (const auto& metric : kCostMetrics)
    out.begin_object()
        .member("name", metric.name)
        .member("unit", metric.unit)
        .member("lower_is_better", metric.is_lower_better)
        .member("log", metric.is_log)
        .end_object();
  out.end_array();
}

void put_definitions(Writer& out) {
  const auto put_one = [&](std::string_view name, std::string_view text) {
    out.begin_object().member("name", name).member("text", text).end_object();
  };
  out.key("definitions").begin_array();
  for (const auto& metric : kCostMetrics) put_one(metric.name, metric.definition);
  put_one("cpu_seconds", "user and system time of all processes of a render; the median of its seeds");
  put_one("wall_seconds", "from the start of the program to its end; the median of its seeds");
  put_one("render_seconds", "what the renderer states itself; the median of its seeds");
  put_one("interval",
          "95 % confidence: of medians between order statistics (of fewer than six values all of them), of "
          "means by Student's distribution");
  put_one("fixed_cpu_seconds", "the scene in 4 x 4 px with 8 samples: start, reading, building, writing");
  put_one(
      "fit",
      "relmse(t) = bias_squared + variance / t^exponent, t: CPU seconds above the fixed cost that the samples "
      "take at the renderer's mean rate; weighted least squares. A floor is called where bias_squared is above 0 "
      "at a level of 1 in 1000, the model is not refuted, and a third of the last rung's error is bias");
  put_one("prices",
          "CPU seconds to a level, the fixed cost included: between two rungs, linear in the logarithms; "
          "never beyond the rungs");
  put_one("efficiency", "1 / (relmse x CPU seconds) at the last rung that the reference can judge");
  put_one("seconds_per_db",
          "the share by which the time grows for one more decibel, between the two last such rungs");
  put_one("on_frontier", "no other point of the scene, of any renderer, is cheaper and has less relmse");
  put_one("below_reference_noise", "the noise of the reference makes more relmse than the renderer");
  out.end_array();
}

std::string number_text(const std::optional<double>& number) {
  return number ? fmt::format("{}", *number) : "";
}

}  // namespace

std::string cost_json(const CostRecord& record) {
  const auto numbers = cost_numbers(record);
  Writer out;
  out.begin_object().member("format", results::kCostFormat);
  results::write_fields(out, record);
  put_definitions(out);
  put_metrics(out);
  out.key("curves").begin_array();
  for (const auto& curve : numbers.curves) put_curve(out, record, curve);
  out.end_array();
  out.key("comparisons").begin_array();
  for (const auto& comparison : numbers.comparisons) put_comparison(out, comparison);
  out.end_array();
  put_self_comparison(out, record, numbers.self_comparison);
  return out.end_object().text();
}

CostRecord read_cost_file(const std::filesystem::path& file) {
  const auto document = json::parse_file(file);
  json::ObjectReader in(document);
  results::check_format(in, results::kCostFormat);
  CostRecord record;
  results::FieldReader read(in);
  fields(read, record);
  for (const auto& ladder : record.ladders)
    if (ladder.target >= record.targets.size() || ladder.renderer >= record.renderers.size())
      throw InputError(fmt::format("{}: a ladder is of target {} and renderer {}, which are not listed",
                                   file.string(), ladder.target, ladder.renderer));
  for (const auto& render : record.renders)
    if (render.target >= record.targets.size() || render.renderer >= record.renderers.size())
      throw InputError(fmt::format("{}: a render is of target {} and renderer {}, which are not listed",
                                   file.string(), render.target, render.renderer));
  return record;
}

std::string cost_csv(const CostRecord& record) {
  std::string text =
      "target,renderer,purpose,rung,spp,seed,order,cpu_seconds,wall_seconds,render_seconds,load,relmse,mse,psnr_srgb8,"
      "flip\n";
  for (const auto& render : record.renders)
    text += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", record.targets[render.target].name,
                        record.renderers[render.renderer].name, render.purpose, render.rung, render.spp,
                        render.seed, render.order, render.cpu_seconds, render.wall_seconds,
                        number_text(render.render_seconds), render.load, number_text(render.relmse),
                        number_text(render.mse), number_text(render.psnr_srgb8), number_text(render.flip));
  return text;
}

}  // namespace orbs::studies
